// Planes at 0, discs that cut, interiors that a camera starts in, bounds that are too small, things that are too far away,
// negative radii and negative light look as POV-Ray renders them.

#include "tests/golden/agreement.h"
#include "tests/golden/bounds_scenes.h"
#include "tests/golden/run.h"

#include <gtest/gtest.h>

namespace firstlight::golden {

// GoogleTest looks for this in the namespace of the type.
static void PrintTo(const BoundsScene& scene, std::ostream* stream) { *stream << scene.text; }

namespace {

class Bounds : public testing::TestWithParam<BoundsScene> {};

TEST_P(Bounds, AgreeWithPovRay) {
  const BoundsScene& given = GetParam();
  const ScratchFolder scratch;
  GoldenScene scene;
  scene.name = "bounds_" + given.name;
  scene.file = scratch.write("scene.pov", given.text);
  scene.share = given.share;
  std::vector<std::string> words{"+W80", "+H60"};
  words.insert(words.end(), given.words.begin(), given.words.end());
  expect_agreement(scene, words);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Bounds, testing::ValuesIn(bounds_scenes()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace firstlight::golden
