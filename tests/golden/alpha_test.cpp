// The share that shows through a picture with an alpha channel is that of POV-Ray's.

#include "render/image/image_io.h"
#include "tests/golden/agreement.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace firstlight::golden {

/// A scene of testscenes/alpha, and words that both programs understand.
struct ClearScene {
  const char* scene;
  std::vector<std::string> words;
};

// GoogleTest looks for this in the namespace of the type.
static void PrintTo(const ClearScene& given, std::ostream* stream) {
  *stream << given.scene;
  for (const std::string& word : given.words) *stream << ' ' << word;
}

namespace {

namespace fs = std::filesystem;

const fs::path kFolder = testscenes() / "alpha";

class Alpha : public testing::TestWithParam<ClearScene> {};

std::string name_of(const ClearScene& given) {
  std::string name = given.scene;
  for (const std::string& word : given.words) name += word;
  return test_name(name);
}

render::Raster raster_of(const ScratchFolder& scratch, const std::string& program, const std::string& scene,
                         const std::string& file, std::vector<std::string> words) {
  words.emplace_back("+UA");
  const ProcessResult result = render(program, kFolder / (scene + ".pov"), scratch / file, scratch.path(), words);
  EXPECT_TRUE(result.succeeded()) << file << ": " << result.summary() << '\n' << result.err;
  std::string error;
  render::Raster raster = render::read_raster((scratch / file).string(), error);
  EXPECT_EQ(error, "");
  return raster;
}

TEST_P(Alpha, AgreesWithPovRay) {
  const ClearScene& given = GetParam();
  std::vector<std::string> words = given.words;
  words.emplace_back("+UA");
  expect_agreement({"alpha_" + name_of(given), kFolder / (std::string(given.scene) + ".pov"), 99.5, {}}, words);
  const ScratchFolder scratch;
  const render::Picture picture =
      to_picture(raster_of(scratch, program_under_test(), given.scene, "ours.png", given.words));
  const std::set<int> seen(picture.alpha.begin(), picture.alpha.end());
  EXPECT_GT(seen.size(), 3u) << "hardly anything shows through";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Alpha,
                         testing::ValuesIn(std::vector<ClearScene>{{"background", {}},
                                                                   {"background", {"+A0.1", "-J", "+AM1"}},
                                                                   {"background", {"+A0.1", "-J", "+AM2"}},
                                                                   {"background", {"+THFS"}},
                                                                   {"background", {"+THB4"}},
                                                                   {"glass", {}},
                                                                   {"glass", {"+A0.1", "-J", "+AM2"}},
                                                                   {"sky", {}},
                                                                   {"fog", {}},
                                                                   {"old_rules", {}},
                                                                   {"fisheye", {}}}),
                         [](const auto& info) { return name_of(info.param); });

/// The numbers of a file, as shares of white.
std::vector<double> numbers_of(const render::Raster& raster) {
  std::vector<double> numbers(static_cast<std::size_t>(raster.width * raster.height * raster.channels));
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = raster.value(i);
  return numbers;
}

TEST(AlphaFiles, HaveTheNumbersOfPovRays) {
  struct Type {
    const char* option;
    const char* file;
    int channels;
  };
  for (const Type& type : {Type{"+FN16", "a.png", 4}, Type{"+FNg", "b.png", 2}, Type{"+FT", "c.tga", 4},
                           Type{"+FC", "d.tga", 4}, Type{"+FB", "e.bmp", 4}, Type{"+FP", "f.ppm", 3}}) {
    const ScratchFolder scratch;
    const render::Raster theirs =
        raster_of(scratch, "povray", "background", std::string("theirs-") + type.file, {type.option});
    const render::Raster ours =
        raster_of(scratch, program_under_test(), "background", std::string("ours-") + type.file, {type.option});
    ASSERT_EQ(ours.channels, type.channels) << type.option;
    ASSERT_EQ(theirs.channels, type.channels) << type.option;
    const std::vector<double> a = numbers_of(ours);
    const std::vector<double> b = numbers_of(theirs);
    ASSERT_EQ(a.size(), b.size());
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) apart += std::abs(a[i] - b[i]) > 1.001 / 255.0 ? 1 : 0;
    EXPECT_LE(apart, a.size() / 500) << type.option;
  }
}

// POV-Ray of Debian writes no OpenEXR files.
TEST(AlphaFiles, OfLightHaveColorsMultipliedByAlpha) {
  const ScratchFolder scratch;
  const render::Raster light = raster_of(scratch, program_under_test(), "background", "light.exr", {"+FE"});
  const render::Raster words =
      raster_of(scratch, program_under_test(), "background", "words.png", {"+FN16", "File_Gamma=1"});
  ASSERT_EQ(light.channels, 4);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < numbers_of(light).size(); i += 4) {
    const double alpha = light.value(i + 3);
    if (std::abs(alpha - words.value(i + 3)) > 1e-4) continue;  // larger in the other, for a highlight
    for (std::size_t c = 0; c < 3; ++c) {
      if (words.value(i + c) == 1.0) continue;
      EXPECT_NEAR(light.value(i + c), words.value(i + c) * alpha, 2e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, numbers_of(light).size() / 2);
}

TEST(AlphaFiles, AreTheSameBytesInAnyOrder) {
  const ScratchFolder scratch;
  const auto numbers = [&](const std::string& file, const std::vector<std::string>& words) {
    return numbers_of(raster_of(scratch, program_under_test(), "glass", file, words));
  };
  const std::vector<double> expected = numbers("a.png", {"--threads=1", "+FN16"});
  EXPECT_EQ(numbers("b.png", {"--threads=2", "--scheme=level", "+FN16"}), expected);
  EXPECT_EQ(numbers("c.png", {"--threads=2", "--scheme=recursive", "+FN16"}), expected);
  EXPECT_EQ(numbers("d.png", {"--threads=3", "--queue-memory=64k", "+FN16"}), expected);
}

}  // namespace
}  // namespace firstlight::golden
