// The order of the rays is free: every scheme, with one thread and with two, writes the same bytes.

#include "tests/golden/picture.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace firstlight::golden {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class SameBytes : public testing::TestWithParam<const char*> {};

TEST_P(SameBytes, WhateverTheSchemeAndTheThreads) {
  const std::filesystem::path scene = testscenes() / GetParam();
  const ScratchFolder scratch;
  std::string why;
  const auto render_with = [&](const std::string& scheme, int threads) {
    const auto file = scratch / fmt::format("{}-{}.png", scheme, threads);
    const ProcessResult result = render(program_under_test(), scene, file, scratch.path(),
                                        {"--scheme", scheme, "--threads", fmt::format("{}", threads)});
    EXPECT_TRUE(result.succeeded()) << scheme << ", " << threads << " threads: " << result.summary() << '\n'
                                    << result.err;
    return file;
  };

  const auto first = render_with("recursive", 1);
  const auto first_picture = read_picture(first, why);
  ASSERT_TRUE(first_picture) << why;
  for (const char* scheme : {"recursive", "contribution", "level", "ray-type"}) {
    for (const int threads : {1, 2}) {
      SCOPED_TRACE(fmt::format("{}, {} threads, against recursive with one", scheme, threads));
      const auto file = render_with(scheme, threads);
      const auto picture = read_picture(file, why);
      ASSERT_TRUE(picture) << why;
      EXPECT_EQ(*picture, *first_picture) << summary(difference(*picture, *first_picture));
      EXPECT_EQ(bytes_of(file), bytes_of(first)) << "the same pixels in other bytes";
    }
  }
}

// Mirrors and many levels; refraction and coloured shadows; constructive geometry; textures with transformed patterns;
// rounds of samples.
INSTANTIATE_TEST_SUITE_P(Scenes, SameBytes,
                         testing::Values("full/mirror_room.pov", "interior/refraction.pov", "shapes/difference.pov",
                                         "lights/coloured_shadows.pov", "finishes/reflection_forms.pov",
                                         "cameras/blur_19.pov"),
                         [](const auto& info) { return test_name(info.param); });

}  // namespace
}  // namespace firstlight::golden
