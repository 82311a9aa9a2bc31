// Pictures of every quality look as POV-Ray's.

#include "tests/golden/agreement.h"
#include "tests/golden/picture.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

class QualityLevel : public testing::TestWithParam<int> {};

TEST_P(QualityLevel, AgreesWithPovRay) {
  expect_agreement({fmt::format("quality_{}", GetParam()), testscenes() / "global/quality.pov", 99, {}},
                   {fmt::format("+Q{}", GetParam())});
}

INSTANTIATE_TEST_SUITE_P(Levels, QualityLevel, testing::Range(0, 12));

Picture picture_of(int level) {
  const ScratchFolder scratch;
  const ProcessResult result = render(program_under_test(), testscenes() / "global/quality.pov",
                                      scratch / "picture.png", scratch.path(), {fmt::format("+Q{}", level)});
  EXPECT_TRUE(result.succeeded()) << result.err;
  std::string why;
  return read_picture(scratch / "picture.png", why).value_or(Picture{});
}

TEST(Quality, HasSevenLevelsThatDiffer) {
  constexpr int kFirst[] = {0, 2, 4, 5, 6, 8, 9};
  for (std::size_t i = 1; i < std::size(kFirst); ++i) {
    EXPECT_LT(difference(picture_of(kFirst[i - 1]), picture_of(kFirst[i])).share, 0.97) << kFirst[i];
  }
  EXPECT_EQ(picture_of(0), picture_of(1));
  EXPECT_EQ(picture_of(2), picture_of(3));
  EXPECT_EQ(picture_of(6), picture_of(7));
  EXPECT_EQ(picture_of(9), picture_of(11));
}

// Matter that fills the space is not asked for, nor light that goes round.
TEST(Quality, BelowNineNeedsNoMatter) {
  const ScratchFolder scratch;
  const auto scene =
      scratch.write("scene.pov",
                    "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 20 } photons { "
                    "spacing 0.1 } }\n"
                    "camera { location <0, 1, -5> look_at 0 } light_source { <3, 5, -4> rgb 1 }\n"
                    "media { scattering { 1, 0.1 } }\n"
                    "sphere { 0, 1 hollow pigment { rgbf <1, 0.5, 0.5, 0.8> } interior { ior 1.3 media { "
                    "emission 0.5 } } photons { target } }\n"
                    "plane { y, -1 pigment { checker rgb 1, rgb 0.4 } finish { ambient 0.3 } }\n");
  expect_agreement({"quality_without_matter", scene, 99, {}}, {"+Q8"});
}

}  // namespace
}  // namespace firstlight::golden
