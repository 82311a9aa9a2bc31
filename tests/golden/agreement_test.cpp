// Every scene looks as POV-Ray renders it: POV-Ray renders it here and now, and the two pictures are compared.

#include "tests/golden/agreement.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace firstlight::golden {

// GoogleTest looks for this in the namespace of the type.
static void PrintTo(const GoldenScene& scene, std::ostream* stream) { *stream << scene.file.string(); }

namespace {

namespace fs = std::filesystem;

class Golden : public testing::TestWithParam<GoldenScene> {};

TEST_P(Golden, AgreesWithPovRay) {
  const GoldenScene& scene = GetParam();
  ASSERT_TRUE(fs::exists(scene.file)) << scene.file << " is missing (Debian package povray-examples?)";
  expect_agreement(scene);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(golden_scenes()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace firstlight::golden
