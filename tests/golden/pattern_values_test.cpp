// Noise, turbulence and patterns have POV-Ray's values: both programs write what their functions give at the same
// random places, in one run each.

#include "render/image/image_io.h"
#include "render/texture/pattern_kind.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr int kPlaces = 1000;
constexpr double kTolerance = 1e-9;
/// Colours are floats in POV-Ray.
constexpr double kColorTolerance = 3e-7;
constexpr std::chrono::seconds kLimit{120};

/// The lines of pattern_values.txt, those with `noise_generator N` three times.
std::vector<std::string> patterns() {
  std::vector<std::string> all;
  std::ifstream file(fs::path(FIRSTLIGHT_SOURCE_DIR) / "tests/golden/pattern_values.txt");
  constexpr std::string_view kEach = "noise_generator N";
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.starts_with("//")) continue;
    const std::size_t at = line.find(kEach);
    if (at == std::string::npos) {
      all.push_back(line);
      continue;
    }
    for (const char* generator : {"1", "2", "3"})
      all.push_back(std::string(line).replace(at + kEach.size() - 1, 1, generator));
  }
  return all;
}

/// Functions of noise with the generator of the whole scene.
const std::vector<std::string> kNoise = {"f_noise3d(x, y, z)",
                                         "f_noise_generator(x, y, z, 1)",
                                         "f_noise_generator(x, y, z, 2)",
                                         "f_noise_generator(x, y, z, 3)",
                                         "f_ridged_mf(x, y, z, 0.3, 3, 5, 0.7, 2, 1)",
                                         "f_ridged_mf(x, y, z, 0.3, 3, 5, 0.7, 2, 3)",
                                         "f_hetero_mf(x, y, z, 0.3, 3, 5, 0.7, 0.5, 2)"};

/// Value that the language itself gives at the place <X, Y, Z>.
const std::vector<std::string> kExpressions = {"vturbulence(2, 0.5, 6, <X,Y,Z>).x", "vturbulence(2, 0.5, 6, <X,Y,Z>).y",
                                               "vturbulence(1.7, 0.3, 3, <X,Y,Z>*0.3).z",
                                               "vturbulence(3, 0.8, 10, <Z,X,Y>).x"};

constexpr std::string_view kPigment = "pigment { ";

bool is_pigment(const std::string& body) { return body.starts_with(kPigment); }
bool is_expression(const std::string& body) {
  return body.find("<X,Y,Z>") != std::string::npos || body.find("<Z,X,Y>") != std::string::npos;
}

/// A scene that writes the value of each function at each place, one a line, and ends.
std::string scene_of(const std::vector<std::string>& bodies, int generator) {
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1 noise_generator {} }}\n#include \"functions.inc\"\n"
      "#fopen File \"values.txt\" write\n#declare Dice = seed(17);\n",
      generator);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_expression(bodies[i])) text += fmt::format("#declare F{} = function {{ {} }}\n", i, bodies[i]);
  }
  text += fmt::format("#declare I = 0;\n#while (I < {})\n#declare Size = (mod(I, 10) = 9 ? 1000 : 12);\n", kPlaces);
  for (const char* axis : {"X", "Y", "Z"}) text += fmt::format("#declare {} = (rand(Dice) - 0.5)*Size;\n", axis);
  text += "#write (File";
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    text += is_expression(bodies[i])
                ? fmt::format(",str({},0,12),\"\\n\"", bodies[i])
                : fmt::format(",str(F{}(X,Y,Z){},0,12),\"\\n\"", i, is_pigment(bodies[i]) ? ".green" : "");
  }
  return text + ")\n#declare I = I + 1;\n#end\n#fclose File\n#error \"written\"\n";
}

/// The numbers that `program` writes; it reads the pictures of testscenes from the folder where it runs.
std::vector<double> values_by(const std::string& program, const std::string& scene) {
  const ScratchFolder scratch;
  const fs::path file = scratch.write("values.pov", scene);
  for (const char* image : {"rgb.png", "grey16.png", "grid8.df3"})
    fs::copy(testscenes() / "patterns" / "images" / image, scratch.path());
  const ProcessResult result =
      run_process({program, "+I" + file.string(), "-F", "-D", "+W16", "+H12"}, scratch.path(), scratch.path(), kLimit);
  std::vector<double> values;
  std::ifstream written(scratch / "values.txt");
  for (std::string line; std::getline(written, line);) values.push_back(std::strtod(line.c_str(), nullptr));
  EXPECT_FALSE(values.empty()) << program << ": " << result.err.substr(0, 3000);
  return values;
}

/// Both programs write the values of `bodies`; what differs is named with its worst difference.
void expect_equal_values(const std::vector<std::string>& bodies, int generator) {
  const std::string scene = scene_of(bodies, generator);
  const std::vector<double> theirs = values_by("povray", scene), ours = values_by(program_under_test(), scene);
  ASSERT_EQ(theirs.size(), bodies.size() * kPlaces);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t function = 0; function < bodies.size(); ++function) {
    const double tolerance = is_pigment(bodies[function]) ? kColorTolerance : kTolerance;
    int differ = 0;
    double worst = 0, sum = 0;
    for (std::size_t i = function; i < ours.size(); i += bodies.size()) {
      const double difference = std::abs(ours[i] - theirs[i]);
      if (!(difference <= tolerance * std::max(1.0, std::abs(theirs[i])))) ++differ;
      worst = std::max(worst, difference);
      sum += std::abs(theirs[i] - theirs[function]);
    }
    EXPECT_EQ(differ, 0) << bodies[function] << ": worst " << worst;
    EXPECT_GT(sum, 0) << bodies[function] << " is the same everywhere, which proves nothing";
  }
}

TEST(PatternValues, AreThoseOfPovRay) {
  std::vector<std::string> bodies;
  for (const std::string& pattern : patterns())
    bodies.push_back(is_pigment(pattern) ? pattern : "pattern { " + pattern + " }");
  expect_equal_values(bodies, 2);
}

TEST(PatternValues, NoiseInFunctionsIsThatOfPovRay) {
  for (int generator = 1; generator <= 3; ++generator) expect_equal_values(kNoise, generator);
}

TEST(PatternValues, TurbulenceInExpressionsIsThatOfPovRay) { expect_equal_values(kExpressions, 2); }

/// Numbers of a picture of 16 bits a channel, proportional to what is seen.
std::vector<int> numbers_of(const std::string& program, const std::string& scene) {
  const ScratchFolder scratch;
  const fs::path file = scratch.write("surfaces.pov", scene);
  const ProcessResult result = run_process({program, "+I" + file.string(), "+O" + (scratch / "picture.png").string(),
                                            "+FN16", "File_Gamma=1", "-A", "-J", "-D", "+W160", "+H120", "+WT1"},
                                           scratch.path(), scratch.path(), kLimit);
  EXPECT_TRUE(result.succeeded()) << program << ": " << result.err.substr(0, 3000);
  std::string error;
  const render::Raster raster = render::read_raster((scratch / "picture.png").string(), error);
  std::vector<int> numbers;
  std::visit([&](const auto& samples) { numbers.assign(samples.begin(), samples.end()); }, raster.samples);
  return numbers;
}

// Patterns that no function can ask, for they depend on the surface and on who looks at it, are read off pictures.
TEST(PatternValues, OfSurfacesAreThoseOfPovRay) {
  const std::string head =
      "#version 3.7; global_settings { assumed_gamma 1 }\n"
      "camera { orthographic location -5*z right 8*x up 6*y look_at 0 }\n"
      "light_source { <-100, 200, -300> rgb 1 parallel point_at 0 }\n"
      "#default { finish { ambient 1 diffuse 0 } }\n"
      "#declare Grey = color_map { [0 rgb 0] [1 rgb 1] }\n";
  for (const char* surface :
       {"sphere { 0, 2.8 pigment { aoi color_map { Grey } } }",
        "sphere { 0, 2.8 pigment { aoi frequency 3 sine_wave color_map { Grey } } normal { bumps 0.4 scale 0.3 } }",
        "torus { 2, 0.8 rotate 50*x pigment { slope y color_map { Grey } } }",
        "torus { 2, 0.8 rotate 50*x pigment { slope { <1, 2, -3>, 0.1, 0.8 altitude <0.4, 1, 0.2>, -0.4, 0.6 } "
        "color_map { Grey } } }",
        "sphere { 0, 2.8 pigment { slope { <0.3, -1, 0.4> } color_map { Grey } } }",
        "sphere { 0, 2.8 pigment { rgb 1 } finish { ambient 0 diffuse 1 } normal { facets size 0.4 } }",
        "sphere { 0, 2.8 pigment { rgb 1 } finish { ambient 0 diffuse 1 } normal { facets coords 0.5 } }",
        "box { -2, 2 texture { tiles { texture { pigment { gradient x color_map { Grey } } } tile2 texture { pigment { "
        "gradient y color_map { Grey } } } } scale 0.4 } }"}) {
    const std::vector<int> theirs = numbers_of("povray", head + surface);
    const std::vector<int> ours = numbers_of(program_under_test(), head + surface);
    ASSERT_EQ(ours.size(), theirs.size());
    std::size_t apart = 0;
    std::set<int> seen;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      apart += std::abs(ours[i] - theirs[i]) > 3 ? 1 : 0;
      seen.insert(theirs[i]);
    }
    EXPECT_LE(apart, ours.size() / 1000) << surface;
    EXPECT_GT(seen.size(), 20u) << surface << " is nearly the same everywhere, which proves nothing";
  }
}

/// Whether a pattern is one that functions can ask: the others need a surface, or are maps.
bool is_function(const std::string& word) {
  static const std::set<std::string> kOthers = {"aoi",          "average", "bump_map", "facets",    "image_map",
                                                "material_map", "slope",   "tiles",    "uv_mapping"};
  return !kOthers.contains(word);
}

TEST(PatternValues, HaveALineForEachPattern) {
  using render::PatternKind;
  std::set<std::string> there;
  for (std::string pattern : patterns()) {
    if (is_pigment(pattern)) pattern.erase(0, kPigment.size());
    there.insert(pattern.substr(0, pattern.find(' ')));
  }
  for (int i = static_cast<int>(PatternKind::plain) + 1; i <= static_cast<int>(PatternKind::wrinkles); ++i) {
    const std::string word(render::spelling(static_cast<PatternKind>(i)));
    EXPECT_TRUE(there.contains(word) || !is_function(word)) << word;
  }
}

}  // namespace
}  // namespace firstlight::golden
