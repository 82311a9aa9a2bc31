// Work that would last for days ends when it shall: by the clock with the picture as it is then, by signals without one.

#include "tests/golden/picture.h"
#include "tests/golden/refusal.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

#ifdef FIRSTLIGHT_SANITIZED
constexpr double kSlower = 10.0;
#else
constexpr double kSlower = 1.0;
#endif

struct EndlessScene {
  const char* name;
  const char* text;
};

constexpr EndlessScene kScenes[] = {
    {"mandel", "sphere { 0, 1 pigment { mandel 2000000000 color_map { [0 rgb 0] [1 rgb 1] } } }"},
    {"julia", "plane { z, 1 pigment { julia <0.353, 0.288>, 1000000000 color_map { [0 rgb 0] [1 rgb 1] } scale 10 } }"},
    {"intersection_of_100000",
     "intersection { #for (I, 1, 100000) sphere { <0, 0, I*1e-7>, 1 } #end pigment { rgb 1 } }"},
    {"clips",
     "union { #for (I, 1, 20000) sphere { <0, 0, I*1e-7>, 1 } #end pigment { rgb 1 }\n"
     "  clipped_by { intersection { #for (I, 1, 20000) sphere { <0, 0, I*1e-7>, 1 } #end } } }"},
    {"isosurface", "isosurface { function { 0 } accuracy 1e-12 pigment { rgb 1 } }"},
    {"julia_fractal", "julia_fractal { 0.1 max_iteration 100000 precision 1e9 pigment { rgb 1 } }"},
    {"parametric",
     "parametric { function { u } function { v } function { u*v } <-1, -1>, <1, 1> max_gradient 1e6 accuracy 1e-9 }"},
    {"glass_in_the_light",
     "#for (I, 1, 30000) sphere { <0, 0, I*1e-7>, 1 pigment { rgbt 0.9999 } } #end\n"
     "plane { z, 2 pigment { rgb 1 } }"},
};

std::string text_of(const EndlessScene& scene) {
  return fmt::format(
      "#version 3.7; global_settings {{ assumed_gamma 1 adc_bailout 0 max_trace_level 200 }}\n"
      "camera {{ location <0, 0, -5> look_at 0 }}\nlight_source {{ <5, 5, -5>, 1 }}\n{}\n",
      scene.text);
}

double trace_seconds(const fs::path& stats) {
  std::ifstream stream(stats);
  return nlohmann::json::parse(stream, nullptr, /*allow_exceptions=*/false).value("/time/trace_s"_json_pointer, 0.0);
}

class EndlessScenes : public testing::TestWithParam<EndlessScene> {};

TEST_P(EndlessScenes, EndsByTheClockWithThePictureAsItIs) {
  const ScratchFolder scratch;
  const fs::path scene = scratch.write("scene.pov", text_of(GetParam()));
  for (const char* scheme : {"contribution", "recursive"}) {
    SCOPED_TRACE(scheme);
    const auto result = run_process({program_under_test(), scene.string(), "+Opicture.png", "--stop-after", "1",
                                     "--scheme", scheme, "--threads", "2", "--stats", "stats.json"},
                                    scratch.path(), scratch.path(), kRenderLimit);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    std::string why;
    EXPECT_TRUE(read_picture(scratch / "picture.png", why)) << why;
    const auto trace = trace_seconds(scratch / "stats.json");
    EXPECT_GT(trace, 0.9) << "it was no endless work";
    EXPECT_LT(trace, 1.5 * kSlower);
  }
}

TEST(EndlessWork, AStepThatIsInterruptedIsNoPartOfThePicture) {
  const ScratchFolder scratch;
  const fs::path scene = scratch.write(
      "scene.pov",
      "#version 3.7; camera { location <0, 0, -5> look_at 0 }\n"
      "plane { z, 1 pigment { mandel 2000000000 color_map { [0 rgb 1] [1 rgb 1] } scale 1e4 } finish { emission 1 } }");
  for (const char* scheme : {"contribution", "recursive"}) {
    SCOPED_TRACE(scheme);
    const auto result = run_process({program_under_test(), scene.string(), "+W64", "+H48", "+Opicture.png",
                                     "--stop-after", "0.3", "--scheme", scheme, "--threads", "2"},
                                    scratch.path(), scratch.path(), kRenderLimit);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    std::string why;
    const auto picture = read_picture(scratch / "picture.png", why);
    ASSERT_TRUE(picture) << why;
    EXPECT_TRUE(std::all_of(picture->rgb.begin(), picture->rgb.end(), [](int channel) { return channel == 0; }));
  }
}

/// Seconds of the two times in "0m1.230s 0m0.040s", as `times` of the shell writes them.
double processor_seconds(const std::string& line) {
  double sum = 0.0;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const std::size_t minutes = word.find('m');
    sum += 60.0 * std::stod(word.substr(0, minutes)) + std::stod(word.substr(minutes + 1));
  }
  return sum;
}

TEST_P(EndlessScenes, EndsBySignalsWithoutAPicture) {
  const ScratchFolder scratch;
  scratch.write("scene.pov", text_of(GetParam()));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) {
    SCOPED_TRACE(signal);
    // The ticks of the processor that the program has had, the moment, the end, the moment, what it has had in all.
    const auto result = run_process(
        {"sh", "-c",
         fmt::format("'{}' scene.pov --steer socket & P=$!; sleep 1.5; awk '{{print $14 + $15}}' /proc/$P/stat; "
                     "date +%s.%N; kill -{} $P; wait $P; C=$?; date +%s.%N; times; exit $C",
                     program_under_test(), signal)},
        scratch.path(), scratch.path(), kRenderLimit);
    EXPECT_EQ(result.exit_code, 130) << result.summary() << '\n' << result.err;
    EXPECT_NE(result.err.find("interrupted"), std::string::npos) << result.err;
    EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 1) << "something is left besides the scene";
    const auto lines = lines_of(result.out);
    ASSERT_EQ(lines.size(), 5u) << result.out;
    const double passed = std::stod(lines[2]) - std::stod(lines[1]);
    const double before = std::stod(lines[0]) / static_cast<double>(sysconf(_SC_CLK_TCK));
    const double worked = processor_seconds(lines[4]) - before;
    // On a machine that is busy with other things the program has to wait for its turn.
    EXPECT_LT(std::min(passed, worked), 0.5 * kSlower) << "passed " << passed << " s, worked " << worked << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(All, EndlessScenes, testing::ValuesIn(kScenes),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace firstlight::golden
