// Scenes that nobody wrote look as POV-Ray renders them. firstlight_random_scenes tries more of them.

#include "tests/golden/agreement.h"
#include "tests/golden/random_scene.h"
#include "tests/golden/run.h"

#include <gtest/gtest.h>

namespace firstlight::golden {
namespace {

class RandomCsg : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomCsg, AgreesWithPovRay) {
  const ScratchFolder scratch;
  GoldenScene scene;
  scene.name = "random_csg_" + std::to_string(GetParam());
  scene.file = scratch.write("scene.pov", random_csg_scene(GetParam()));
  expect_agreement(scene);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCsg, testing::Range<std::uint64_t>(0, 20));

class Ties : public testing::TestWithParam<std::uint64_t> {};

/// Every twenty-third: all pairs of shapes are among them.
TEST_P(Ties, AgreeWithPovRay) {
  const ScratchFolder scratch;
  GoldenScene scene;
  scene.name = "ties_" + std::to_string(GetParam());
  scene.file = scratch.write("scene.pov", tie_scene(GetParam()));
  expect_agreement(scene);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Ties, testing::Range<std::uint64_t>(0, kTieScenes, 23));

}  // namespace
}  // namespace firstlight::golden
