#include "tests/golden/agreement.h"

#include "app/compare/compare_scene.h"
#include "tests/golden/picture.h"
#include "tests/golden/render.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;
using app::compare::CompareSettings;
using app::compare::SceneJob;
using app::compare::SceneRecord;
using app::compare::Status;

/// Leaves the difference and the numbers beside both pictures, where a person can look at them.
void keep_difference(const fs::path& folder, const SceneRecord& record) {
  std::string why;
  const auto theirs = read_picture(record.povray_picture, why);
  const auto ours = read_picture(record.our_picture, why);
  if (!theirs || !ours || !record.difference) return;
  render::write_picture((folder / "difference.png").string(), app::compare::difference_map(*theirs, *ours));
  std::ofstream(folder / "numbers.txt") << "POV-Ray against Firstlight: " << summary(*record.difference) << '\n';
}

}  // namespace

void expect_agreement(const GoldenScene& scene, const std::vector<std::string>& more) {
  SceneJob job;
  job.scene = scene.file;
  job.name = scene.name;
  job.pictures = fs::path(FIRSTLIGHT_BINARY_DIR) / "golden-failures" / scene.name;
  fs::remove_all(job.pictures);
  fs::create_directories(job.pictures);
  CompareSettings settings;
  settings.width = 160;
  settings.height = 120;
  settings.words = more;
  settings.time_limit = kRenderLimit;
  settings.firstlight = program_under_test();
  settings.thresholds.psnr = scene.psnr;
  if (!scene.psnr) settings.thresholds.share = scene.share;

  const SceneRecord record = app::compare::compare_scene(job, settings);
  ASSERT_TRUE(record.difference) << record.message << '\n' << to_text(record.missing);
  std::cout << scene.name << ": " << summary(*record.difference) << '\n';
  if (record.status == Status::agrees) {
    fs::remove_all(job.pictures);
    return;
  }
  keep_difference(job.pictures, record);
  FAIL() << "POV-Ray against Firstlight: " << summary(*record.difference) << "\nSee " << job.pictures.string();
}

}  // namespace firstlight::golden
