#include "app/stats.h"

#include "app/progress.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace firstlight::app {
namespace {

namespace fs = std::filesystem;

/// An empty folder of its own, gone at the end.
struct Folder {
  Folder()
      : path(fs::path(testing::TempDir()) /
             ("firstlight-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
              testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  const fs::path path;
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Stats, HoldEveryNumberUnderItsName) {
  Stats stats;
  stats.scheme = "level";
  stats.threads = 2;
  stats.width = 30;
  stats.height = 20;
  stats.parse = 0.25;
  stats.first_image = 0.5;
  stats.rays.rays.of(render::RayKind::primary) = 600;
  stats.rays.rays.of(render::RayKind::shadow) = 7;
  stats.rays.peak_rays = 11;
  stats.rays.bytes_per_ray = 64;
  const auto json = nlohmann::json::parse(to_json(stats));
  EXPECT_EQ(json["scheme"], "level");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["width"], 30);
  EXPECT_EQ(json["height"], 20);
  EXPECT_EQ(json["time"]["parse_s"], 0.25);
  EXPECT_EQ(json["time"]["first_image_s"], 0.5);
  EXPECT_EQ(json["rays"]["primary"], 600);
  EXPECT_EQ(json["rays"]["reflection"], 0);
  EXPECT_EQ(json["rays"]["shadow"], 7);
  EXPECT_EQ(json["queue"]["peak_rays"], 11);
  EXPECT_EQ(json["queue"]["bytes_per_ray"], 64);
}

TEST(Stats, SurviveASceneNameThatIsNoText) {
  Stats stats;
  stats.scene = "\xff\xfe.pov";
  EXPECT_FALSE(nlohmann::json::parse(to_json(stats)).is_discarded());
}

TEST(WriteTextFile, ReplacesTheFileAndLeavesNothingElse) {
  const Folder folder;
  const fs::path file = folder.path / "a.json";
  EXPECT_EQ(write_text_file(file.string(), "one"), "");
  EXPECT_EQ(write_text_file(file.string(), "two"), "");
  EXPECT_EQ(text_of(file), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()), 1);
}

TEST(WriteTextFile, SaysWhyItCannot) {
  const Folder folder;
  EXPECT_NE(write_text_file((folder.path / "missing" / "a.json").string(), "one").find("missing"), std::string::npos);
  EXPECT_NE(write_text_file(folder.path.string(), "one"), "");
  EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST(Progress, ShortFormsStayShort) {
  EXPECT_EQ(short_count(0), "0");
  EXPECT_EQ(short_count(9'999), "9999");
  EXPECT_EQ(short_count(12'345), "12 k");
  EXPECT_EQ(short_count(19'000'000), "19.0 M");
  EXPECT_EQ(short_count(2'500'000'000), "2.50 G");
  EXPECT_EQ(short_time(3.417), "3.42 s");
  EXPECT_EQ(short_time(125.4), "2:05 min");
  EXPECT_EQ(short_time(7380.0), "2:03 h");
}

}  // namespace
}  // namespace firstlight::app
