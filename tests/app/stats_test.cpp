#include "app/stats.h"

#include "tests/app/folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iterator>

namespace firstlight::app {
namespace {

namespace fs = std::filesystem;

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
  stats.rays.remaining = 0.125;
  stats.rays.rekeying.count = 3;
  stats.end = priority::End::time_over;
  stats.rays.remaining_is_bound = false;
  stats.queue_memory = 1000;
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
  EXPECT_EQ(json["queue"]["memory"], 1000);
  EXPECT_EQ(json["rekeying"]["count"], 3);
  EXPECT_EQ(json["end"]["reason"], "time-over");
  EXPECT_EQ(json["end"]["remaining"], 0.125);
  EXPECT_EQ(json["end"]["remaining_is_bound"], false);
  EXPECT_TRUE(json["time"]["preview_s"].is_null());
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

}  // namespace
}  // namespace firstlight::app
