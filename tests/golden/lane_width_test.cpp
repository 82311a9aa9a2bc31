// Whole scenes have the same bits at every vector width that the machine has.
#include "parser/parser.h"
#include "priority/driver.h"
#include "render/accel/accel.h"
#include "render/film/film.h"
#include "render/trace/medium_table.h"
#include "tests/golden/scene_list.h"
#include "tests/render/each_target.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

/// Everything between the scene and its colours is made anew: hierarchies and compiled textures use lanes too.
std::vector<render::Rgb> picture_of(const render::Scene& scene) {
  const render::Accel accel(scene);
  render::MediumTable media;
  render::Film film(kWidth, kHeight);
  EXPECT_TRUE(priority::trace({scene, accel, media}, film, {}).complete());
  std::vector<render::Rgb> colors;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) colors.push_back(film.color(x, y));
  }
  return colors;
}

void expect_same_at_every_width(const std::filesystem::path& file) {
  render::LoadOptions options;
  options.width = kWidth;
  options.height = kHeight;
  const render::LoadResult loaded = parser::PovFrontEnd().load(file.string(), options);
  ASSERT_NE(loaded.scene, nullptr) << file;
  std::vector<render::Rgb> first;
  std::string first_target;
  render::for_each_target([&](const std::string& target) {
    const std::vector<render::Rgb> colors = picture_of(*loaded.scene);
    if (first.empty()) {
      first = colors;
      first_target = target;
    }
    EXPECT_EQ(std::memcmp(colors.data(), first.data(), colors.size() * sizeof(render::Rgb)), 0)
        << file << " at " << target << " and " << first_target;
  });
}

/// The names of the folders of testscenes/ whose scenes can be rendered.
std::vector<std::string> folders() {
  std::set<std::string> names;
  for (const GoldenScene& scene : golden_scenes()) {
    const auto relative = scene.file.lexically_relative(testscenes());
    if (!relative.empty() && *relative.begin() != "..") names.insert(relative.begin()->string());
  }
  return {names.begin(), names.end()};
}

class LaneWidths : public testing::TestWithParam<std::string> {};

TEST_P(LaneWidths, GiveTheSameBits) {
  for (const GoldenScene& scene : golden_scenes()) {
    const auto relative = scene.file.lexically_relative(testscenes());
    if (!relative.empty() && relative.begin()->string() == GetParam()) expect_same_at_every_width(scene.file);
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, LaneWidths, testing::ValuesIn(folders()),
                         [](const auto& folder) { return test_name(folder.param); });

}  // namespace
}  // namespace firstlight::golden
