#include "app/compare/report/pages.h"
#include "app/compare/report/places.h"
#include "app/compare/report/report.h"
#include "render/image/image_io.h"
#include "tests/app/compare_example.h"
#include "tests/app/folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

render::Picture grey_picture(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 100)};
}

class CompareReport : public ::testing::Test {
 protected:
  CompareReport() {
    SceneRecord record = rendered_record("shapes/<b>\"x\"&'", 0.99, 0.5);
    record.povray_picture = folder_ / "povray.png";
    record.our_picture = folder_ / "ours.png";
    render::Picture picture = grey_picture(40, 30);
    EXPECT_EQ(render::write_png(record.povray_picture.string(), 40, 30, picture.rgb), "");
    picture.rgb[3 * (4 * 40 + 3)] = 200;
    EXPECT_EQ(render::write_png(record.our_picture.string(), 40, 30, picture.rgb), "");
    records_ = {record, lacking_record("foggy", {"<script>fog"})};
    records_[1].message = "</pre><script>alert(1)</script>";
  }

  std::string write() { return write_report(report_, {records_, "<i>title", "firstlight compare '<u>'"}); }

  Folder folder_;
  fs::path report_ = folder_.path / "out" / "report";
  std::vector<SceneRecord> records_;
};

TEST_F(CompareReport, HasAPageASceneAndThePictures) {
  ASSERT_EQ(write(), "");
  for (const char* file : {"index.html", "scenes/0001-shapes-b-x.html", "scenes/0002-foggy.html",
                           "pictures/0001-shapes-b-x-povray.png", "pictures/0001-shapes-b-x-firstlight-small.png",
                           "pictures/0001-shapes-b-x-difference.png", "pictures/0001-shapes-b-x-flip.png"}) {
    EXPECT_TRUE(fs::is_regular_file(report_ / file)) << file;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path / "out"), fs::directory_iterator()), 1)
      << "nothing is left beside";
}

TEST_F(CompareReport, NeedsNothingFromElsewhere) {
  ASSERT_EQ(write(), "");
  for (const auto& entry : fs::recursive_directory_iterator(report_)) {
    if (entry.path().extension() == ".html") {
      EXPECT_EQ(text_of(entry.path()).find("http"), std::string::npos) << entry.path();
    }
  }
}

TEST_F(CompareReport, WhatScenesSayIsNoMarkup) {
  ASSERT_EQ(write(), "");
  for (const char* page : {"index.html", "scenes/0001-shapes-b-x.html", "scenes/0002-foggy.html"}) {
    const std::string html = text_of(report_ / page);
    for (const char* raw : {"<b>\"x\"", "<script>fog", "<script>alert", "<i>title", "<u>"}) {
      EXPECT_EQ(html.find(raw), std::string::npos) << page << ": " << raw;
    }
  }
  EXPECT_NE(text_of(report_ / "index.html").find("shapes/&lt;b&gt;&quot;x&quot;&amp;"), std::string::npos);
  EXPECT_NE(text_of(report_ / "scenes/0002-foggy.html").find("&lt;script&gt;fog"), std::string::npos);
}

TEST_F(CompareReport, TakesThePlaceOfOneOfBefore) {
  ASSERT_EQ(write(), "");
  records_.pop_back();
  ASSERT_EQ(write(), "");
  EXPECT_FALSE(fs::exists(report_ / "scenes/0002-foggy.html"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path / "out"), fs::directory_iterator()), 1);
}

TEST_F(CompareReport, WhatIsNoReportStays) {
  fs::create_directories(report_);
  folder_.write("out/report/letter.txt", "dear");
  EXPECT_NE(write().find("something that is no report"), std::string::npos);
  EXPECT_EQ(text_of(report_ / "letter.txt"), "dear");
  folder_.write("file", "in the way");
  report_ = folder_.path / "file";
  EXPECT_NE(write(), "");
  report_ = folder_.path / "file" / "below";
  EXPECT_NE(write(), "");
  EXPECT_EQ(text_of(folder_.path / "file"), "in the way");
}

TEST_F(CompareReport, APictureThatCannotBeReadLeavesTheReportOfBefore) {
  ASSERT_EQ(write(), "");
  records_[0].our_picture = folder_ / "gone.png";
  EXPECT_NE(write(), "");
  EXPECT_TRUE(fs::is_regular_file(report_ / "scenes/0001-shapes-b-x.html"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path / "out"), fs::directory_iterator()), 1);
}

TEST(CompareFileStem, IsOfPlainLetters) {
  EXPECT_EQ(file_stem(12, "shapes/sphere +A0.3"), "0012-shapes-sphere-A0-3");
  EXPECT_EQ(file_stem(1, "../../\xff\xfe"), "0001-");
  EXPECT_EQ(file_stem(1, std::string(500, 'a')).size(), 65u);
}

TEST(CompareWorstPlaces, AreOneASquareAndSorted) {
  const render::Picture first = grey_picture(40, 20);
  render::Picture second = first;
  const auto change = [&](std::size_t x, std::size_t y, std::uint8_t value) {
    second.rgb[3 * (y * 40 + x) + 1] = value;
  };
  change(1, 1, 110);
  change(2, 2, 120);  // of the same square
  change(17, 3, 160);
  change(39, 19, 101);
  const std::vector<Place> places = worst_places(first, second, 8);
  ASSERT_EQ(places.size(), 3u);
  EXPECT_EQ(places[0].x, 17);
  EXPECT_EQ(places[0].difference, 60);
  EXPECT_EQ(places[0].second, (std::array{100, 160, 100}));
  EXPECT_EQ(places[1].x, 2);
  EXPECT_EQ(places[2].y, 19);
  EXPECT_EQ(worst_places(first, second, 1).size(), 1u);
  EXPECT_TRUE(worst_places(first, first, 8).empty());
}

}  // namespace
}  // namespace firstlight::app::compare
