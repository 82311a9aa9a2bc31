// Picture files with other numbers than 8 bits on the sRGB curve.
#include "render/image/image_io.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBall =
    "camera { location -4*z look_at 0 }\n"
    "light_source { <5, 5, -9> rgb <1, 0.9, 0.7> }\n"
    "sphere { 0, 1 pigment { gradient y color_map { [0 rgb <0.9, 0.2, 0.1>] [1 rgb <0.1, 0.3, 1.2>] } } finish { phong "
    "0.7 } }\n"
    "background { rgb <0.02, 0.1, 0.5> }\n";

struct Numbers {
  const char* name;
  const char* head;  ///< of the scene
  std::vector<std::string> options;
  int most;  ///< the number of white
};

const Numbers kNumbers[] = {
    {"words", "#version 3.7; global_settings { assumed_gamma 1 }", {"+FN16"}, 65535},
    {"words_of_ppm", "#version 3.7; global_settings { assumed_gamma 1 }", {"+FP16"}, 65535},
    {"gamma", "#version 3.7; global_settings { assumed_gamma 1 }", {"+FN", "File_Gamma=1.8"}, 255},
    {"linear", "#version 3.7; global_settings { assumed_gamma 1 }", {"+FN16", "File_Gamma=1"}, 65535},
    {"two_powers", "#version 3.7; global_settings { assumed_gamma 2.2 }", {"+FN16", "File_Gamma=1.5"}, 65535},
    {"equal_powers", "#version 3.7; global_settings { assumed_gamma 2.2 }", {"+FN16", "File_Gamma=2.2"}, 65535},
    {"power_and_srgb", "#version 3.7; global_settings { assumed_gamma 2.2 }", {"+FN16", "File_Gamma=sRGB"}, 65535},
    {"srgb_and_power", "#version 3.7; global_settings { assumed_gamma srgb }", {"+FN16", "File_Gamma=2.2"}, 65535},
    {"unmanaged", "#version 3.6;", {"+FN16", "File_Gamma=3"}, 65535},
};

void PrintTo(const Numbers& numbers, std::ostream* out) { *out << numbers.name; }

class FileNumbers : public testing::TestWithParam<Numbers> {
 protected:
  std::vector<int> numbers_of(const std::string& program, const char* name) {
    const bool is_ppm = std::string_view(GetParam().options[0]).starts_with("+FP");
    const fs::path picture = scratch_ / (std::string(name) + (is_ppm ? ".ppm" : ".png"));
    const ProcessResult result = render(program, scene_, picture, scratch_.path(), GetParam().options);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    std::string error;
    const render::Raster raster = render::read_raster(picture.string(), error);
    EXPECT_EQ(error, "");
    std::vector<int> numbers;
    std::visit([&](const auto& samples) { numbers.assign(samples.begin(), samples.end()); }, raster.samples);
    return numbers;
  }

  const ScratchFolder scratch_;
  const fs::path scene_ = scratch_.write("scene.pov", std::string(GetParam().head) + "\n" + kBall);
};

TEST_P(FileNumbers, AreThoseOfPovRay) {
  const std::vector<int> theirs = numbers_of("povray", "theirs");
  const std::vector<int> ours = numbers_of(program_under_test(), "ours");
  ASSERT_EQ(ours.size(), theirs.size());
  ASSERT_GT(ours.size(), 160u * 120u);
  const int close = GetParam().most == 255 ? 1 : 64;  // a quarter of an 8-bit step
  std::size_t apart = 0;
  std::size_t within_bytes = 0;  // numbers that 8 bits could tell as well
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::abs(ours[i] - theirs[i]) > close) ++apart;
    if (ours[i] % 257 == 0) ++within_bytes;
  }
  EXPECT_LE(apart, ours.size() / 500);
  if (GetParam().most == 65535) {
    EXPECT_LT(within_bytes, ours.size() / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, FileNumbers, testing::ValuesIn(kNumbers),
                         [](const auto& numbers) { return std::string(numbers.param.name); });

}  // namespace
}  // namespace firstlight::golden
