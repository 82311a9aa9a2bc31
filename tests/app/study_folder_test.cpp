#include "app/study/report_folder.h"
#include "tests/app/study_example.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace firstlight::app {
namespace {

namespace fs = std::filesystem;

class StudyFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::path(::testing::TempDir()) / ("firstlight_study_" + std::string(test->name()) + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  ReportFolder folder() const { return {(folder_ / "a" / "b").string(), 300, 2, render::Encoding::linear()}; }

  fs::path folder_;
};

TEST_F(StudyFolder, HoldsThePageTheNumbersAndThePictures) {
  ReportFolder report = folder();
  ASSERT_EQ(report.prepare(), "");
  const std::vector<render::Rgb> colors(600, render::Rgb(0.5f));
  const std::string png = report.keep_picture(1, "level, sample", 0.051, colors);
  EXPECT_EQ(report.error(), "");
  EXPECT_TRUE(png.starts_with("\x89PNG"));
  ASSERT_EQ(report.write(made_up_study()), "");
  for (const char* file : {"index.html", "summary.csv", "difference.csv", "pictures/02-level-sample-5.png"}) {
    EXPECT_TRUE(fs::is_regular_file(folder_ / "a" / "b" / file)) << file;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "a" / "b" / "pictures"), fs::directory_iterator()), 1)
      << "the small pictures are in the page only";
}

TEST_F(StudyFolder, AFileInItsPlaceIsAnError) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "a") << "in the way";
  EXPECT_NE(folder().prepare().find("cannot make the folder"), std::string::npos);
}

TEST(StudyPictureName, IsOfPlainLetters) {
  EXPECT_EQ(picture_name(0, "recursive", 0.02), "01-recursive-2");
  EXPECT_EQ(picture_name(11, "0.7*contribution + (../x)", 0.6), "12-0.7-contribution-..-x-60");
  EXPECT_EQ(picture_name(1, std::string(500, 'a'), 0.1).size(), 3u + 40u + 3u);
}

}  // namespace
}  // namespace firstlight::app
