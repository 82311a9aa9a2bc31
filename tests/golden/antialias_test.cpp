// Anti-aliased pictures look as POV-Ray's, whatever the method, threshold, depth, gamma, jitter and size of the blocks.

#include "tests/golden/picture.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::golden {

/// Words that both programs understand.
struct AntialiasedScene {
  std::string scene;
  std::vector<std::string> words;
};

// GoogleTest looks for this in the namespace of the type.
static void PrintTo(const AntialiasedScene& scene, std::ostream* stream) {
  *stream << scene.scene;
  for (const std::string& word : scene.words) *stream << ' ' << word;
}

namespace {

class Antialiased : public testing::TestWithParam<AntialiasedScene> {};

Picture render_to(const ScratchFolder& scratch, const std::string& program, const std::string& name,
                  const std::string& scene, const std::vector<std::string>& words) {
  const auto file = scratch / (name + ".png");
  const ProcessResult result = render(program, testscenes() / scene, file, scratch.path(), words);
  EXPECT_TRUE(result.succeeded()) << name << ": " << result.summary() << '\n' << result.err;
  std::string why;
  const auto picture = read_picture(file, why);
  EXPECT_TRUE(picture) << why;
  return picture.value_or(Picture{});
}

TEST_P(Antialiased, AgreesWithPovRay) {
  const AntialiasedScene& given = GetParam();
  const ScratchFolder scratch;
  const Picture reference = render_to(scratch, "povray", "povray", given.scene, given.words);
  const Picture ours = render_to(scratch, program_under_test(), "firstlight", given.scene, given.words);
  const Picture plain = render_to(scratch, program_under_test(), "plain", given.scene, {});
  ASSERT_EQ(ours.rgb.size(), reference.rgb.size());
  ASSERT_EQ(ours.rgb.size(), plain.rgb.size());
  const PictureDifference found = difference(reference, ours);
  std::cout << summary(found) << '\n';
  // Edges are few: a picture without any anti-aliasing may have 98 of 100 pixels right.
  EXPECT_GE(100 * found.share, 99.8) << summary(found);
  EXPECT_LT(difference(reference, plain).share, found.share) << "nothing to be seen of the anti-aliasing";
}

std::vector<AntialiasedScene> with_both_methods() {
  const std::vector<AntialiasedScene> scenes{
      {"shapes/box.pov", {"+A0.3", "+R3", "-J"}},                         // straight edges
      {"shapes/torus.pov", {"+A0.1", "+R2", "-J"}},                       // curved edges
      {"shapes/difference.pov", {"+A0.2", "+R4", "-J"}},                  // edges inside of shapes
      {"full/mirror_room.pov", {"+A0.3", "+R3", "-J"}},                   // edges in mirrors of mirrors
      {"full/still_life.pov", {"+A0.05", "+R2", "-J"}},                   // soft contrasts
      {"patterns/checker.pov", {"+A0.3", "+R5", "-J"}},                   // detail finer than pixels
      {"patterns/filter_transmit.pov", {"+A0.0", "+R2", "-J"}},           // each pixel, behind coloured glass
      {"interior/refraction.pov", {"+A0.3", "+R3", "-J"}},                // bent light
      {"lights/coloured_shadows.pov", {"+A0.1", "+R1", "+J"}},            // shadows; the smallest depth
      {"finishes/reflection_forms.pov", {"+A0.3", "+R3", "-J", "+AG1"}},  // contrast as the colours are
      {"global/gamma_2_2.pov", {"+A0.2", "+R3", "-J"}},                   // colours that are not proportional to light
      {"global/gamma_srgb.pov", {"+A0.2", "+R3", "-J"}},
      {"global/gamma_none_3_6.pov", {"+A0.2", "+R3", "-J", "+AG1.8"}},
      {"cameras/angle_wide.pov", {"+A0.3", "+R3", "-J", "+BS8"}},  // other borders of blocks
      {"full/mirror_room.pov", {"+A", "+J"}},                      // samples moved from their places
      {"patterns/checker.pov", {"+A0.3", "+R2", "+J0.5"}},
      {"cameras/blur_7.pov", {"+A0.1", "+R2", "-J"}},  // places that are means of samples
      {"cameras/aperture.pov", {"+A0.2", "+R2", "+J"}},
  };
  std::vector<AntialiasedScene> out;
  for (const AntialiasedScene& scene : scenes) {
    for (const char* method : {"+AM1", "+AM2"}) {
      out.push_back(scene);
      out.back().words.emplace_back(method);
    }
  }
  return out;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Antialiased, testing::ValuesIn(with_both_methods()), [](const auto& info) {
  std::string name = info.param.scene;
  for (const std::string& word : info.param.words) name += word;
  return test_name(name);
});

TEST(AntialiasedPictures, MethodThreeIsTreatedAsTwoWithAWarning) {
  const ScratchFolder scratch;
  const std::vector<std::string> words{"+A0.3", "-J", "+AM3"};
  const auto file = scratch / "three.png";
  const ProcessResult result =
      render(program_under_test(), testscenes() / "shapes/box.pov", file, scratch.path(), words);
  EXPECT_TRUE(result.succeeded()) << result.err;
  EXPECT_NE(result.err.find("Sampling_Method=3"), std::string::npos) << result.err;
  std::string why;
  const auto three = read_picture(file, why);
  ASSERT_TRUE(three) << why;
  EXPECT_EQ(*three, render_to(scratch, program_under_test(), "two", "shapes/box.pov", {"+A0.3", "-J", "+AM2"}));
  EXPECT_GE(difference(render_to(scratch, "povray", "povray", "shapes/box.pov", words), *three).share, 0.998);
}

TEST(AntialiasedPictures, SchemesAndThreadsEndInTheSamePicture) {
  const ScratchFolder scratch;
  for (const char* method : {"+AM1", "+AM2"}) {
    const auto with = [&](const char* scheme, const char* threads) {
      return render_to(scratch, program_under_test(), "picture", "full/mirror_room.pov",
                       {"+A0.2", method, "--scheme", scheme, "--threads", threads});
    };
    const Picture first = with("recursive", "1");
    for (const char* scheme : {"recursive", "contribution", "level", "ray-type"}) {
      EXPECT_EQ(with(scheme, "2"), first) << method << ' ' << scheme;
    }
  }
}

}  // namespace
}  // namespace firstlight::golden
