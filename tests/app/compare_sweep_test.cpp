#include "app/compare/sweep.h"
#include "app/compare/totals.h"
#include "tests/app/compare_example.h"
#include "tests/app/folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <mutex>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

/// Scenes of a folder, and programs that do not render but count how often they are asked.
class CompareSweep : public ::testing::Test {
 protected:
  CompareSweep() {
    for (const char* name : {"a", "b", "c", "foggy"}) add(name, std::string("// ") + name);
    folder_.write("firstlight", "the program");
    plan_.settings.firstlight = folder_ / "firstlight";
    plan_.settings.stop = &stop_;
    plan_.cache = folder_.path / "cache";
    plan_.compare = [this](const SceneJob& job, const CompareSettings& settings) { return compare(job, settings); };
    plan_.missing = [](const SceneJob& job, const CompareSettings&) {
      return job.name == "foggy" ? std::vector<MissingFeature>{{"fog", "foggy.pov", 1, 1}}
                                 : std::vector<MissingFeature>();
    };
    plan_.ends = [this](const SceneRecord& record, bool) {
      if (record.name == stop_after_) stop_ = true;
    };
  }

  void add(const std::string& name, const std::string& text) {
    fs::create_directories(folder_.path / name);
    ListedScene scene;
    scene.name = name;
    scene.scene = folder_.write(name + "/" + name + ".pov", text);
    plan_.scenes.push_back(scene);
  }

  SceneRecord compare(const SceneJob& job, const CompareSettings& settings) {
    const std::lock_guard lock(mutex_);
    ++asked_;
    if (job.povray == nullptr) ++povray_asked_;
    if (job.name == stop_in_) stop_ = true;
    SceneRecord record = rendered_record(job.name, 0.97, 0.5);
    if (settings.thresholds.share.value_or(98.0) <= 97.0) record.status = Status::agrees;
    record.povray_picture = job.pictures / "povray.png";
    record.our_picture = job.pictures / "firstlight.png";
    std::ofstream(record.povray_picture) << "theirs";
    std::ofstream(record.our_picture) << "ours";
    return record;
  }

  SweepResult run() {
    asked_ = povray_asked_ = 0;
    stop_ = false;
    return sweep(plan_);
  }

  Folder folder_;
  SweepPlan plan_;
  std::atomic<bool> stop_ = false;
  std::string stop_after_, stop_in_;
  std::mutex mutex_;
  int asked_ = 0;
  int povray_asked_ = 0;
};

TEST_F(CompareSweep, GoesThroughTheScenesInTheirOrder) {
  plan_.jobs = 3;
  const SweepResult result = run();
  ASSERT_EQ(result.records.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(result.records[i].name, plan_.scenes[i].name);
  EXPECT_EQ(result.records[3].status, Status::lacks_features);
  EXPECT_EQ(asked_, 3) << "what lacks features is not rendered";
  EXPECT_EQ(text_of(result.records[0].our_picture), "ours");
  EXPECT_EQ(text_of(result.records[0].povray_picture), "theirs");
}

TEST_F(CompareSweep, WhatIsDoneIsNotDoneAgain) {
  const SweepResult first = run();
  const SweepResult second = run();
  EXPECT_EQ(asked_, 0);
  EXPECT_EQ(second.kept, 4u);
  EXPECT_EQ(to_text(totals(second.records)), to_text(totals(first.records)));
}

TEST_F(CompareSweep, GoesOnWhereItWasStopped) {
  const std::string whole = [&] {
    SweepPlan plan = plan_;
    plan.cache = folder_.path / "other";
    return to_text(totals(sweep(plan).records));
  }();
  stop_after_ = "b";
  const SweepResult stopped = run();
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.records.size(), 2u);
  stop_after_.clear();
  const SweepResult rest = run();
  EXPECT_FALSE(rest.stopped);
  EXPECT_EQ(rest.kept, 2u);
  EXPECT_EQ(asked_, 1);
  EXPECT_EQ(to_text(totals(rest.records)), whole);
}

TEST_F(CompareSweep, ASceneDuringWhichItIsStoppedIsNotKept) {
  stop_in_ = "b";
  EXPECT_EQ(run().records.size(), 1u);
  stop_in_.clear();
  EXPECT_EQ(run().kept, 1u);
  EXPECT_EQ(povray_asked_, 2);
}

TEST_F(CompareSweep, AChangedSceneIsRenderedByBoth) {
  run();
  folder_.write("b/b.pov", "// changed");
  EXPECT_EQ(run().kept, 3u);
  EXPECT_EQ(povray_asked_, 1);
}

TEST_F(CompareSweep, AChangedProgramIsAskedWithoutPovray) {
  run();
  folder_.write("firstlight", "the program, mended");
  EXPECT_EQ(run().kept, 0u);
  EXPECT_EQ(asked_, 3);
  EXPECT_EQ(povray_asked_, 0) << "POV-Ray's part is kept";
}

TEST_F(CompareSweep, OptionsAreAsGoodAsAnotherScene) {
  run();
  plan_.settings.words = {"+A0.3"};
  run();
  EXPECT_EQ(povray_asked_, 3);
  plan_.settings.width = 64;
  run();
  EXPECT_EQ(povray_asked_, 3);
  plan_.scenes[0].words = {"+R2"};
  run();
  EXPECT_EQ(povray_asked_, 1);
}

TEST_F(CompareSweep, AgainUsesPovraysPartOnly) {
  run();
  plan_.again = true;
  EXPECT_EQ(run().kept, 0u);
  EXPECT_EQ(asked_, 3);
  EXPECT_EQ(povray_asked_, 0);
}

TEST_F(CompareSweep, ASceneMaySayHowNearIsNearEnough) {
  plan_.scenes[0].share = 95.0;
  EXPECT_EQ(run().records[0].status, Status::agrees);
  plan_.own_thresholds = false;
  EXPECT_EQ(run().records[0].status, Status::differs);
}

TEST_F(CompareSweep, KeptFilesThatAreBrokenAreMadeAnew) {
  run();
  for (const auto& entry : fs::recursive_directory_iterator(plan_.cache)) {
    if (entry.path().extension() == ".json") std::ofstream(entry.path()) << "{\"name\": ";
  }
  EXPECT_EQ(run().kept, 0u);
  EXPECT_EQ(run().kept, 4u);
}

TEST_F(CompareSweep, NothingIsLeftBeside) {
  run();
  for (const auto& entry : fs::directory_iterator(plan_.cache)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.starts_with("povray-") || name.starts_with("scene-")) << name;
  }
}

TEST_F(CompareSweep, ACacheThatCannotBeMadeIsAnError) {
  plan_.cache = folder_ / "firstlight";
  const SweepResult result = run();
  EXPECT_NE(result.error.find("cannot make the folder"), std::string::npos) << result.error;
  EXPECT_EQ(asked_, 0);
}

}  // namespace
}  // namespace firstlight::app::compare
