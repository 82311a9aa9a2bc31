#include "app/study/report.h"

#include "app/study/csv.h"
#include "app/study/thumbnail.h"
#include "tests/app/study_example.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace firstlight::app {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// Names of the elements that are opened and not closed in their order; empty for a well-formed page.
std::string wrongly_nested(const std::string& html) {
  const std::set<std::string> without_end{"!DOCTYPE", "meta", "img", "br"};
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    std::string name = html.substr(at + 1, html.find_first_of(" >/", at + 2) - at - 1);
    if (name.starts_with('/')) {
      if (open.empty() || open.back() != name.substr(1)) return name + " after " + (open.empty() ? "" : open.back());
      open.pop_back();
    } else if (html[end - 1] != '/' && !without_end.contains(name)) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : open.back();
}

/// The page without its script, in which < is no tag.
std::string page(const Study& study) {
  std::string html = report_html(study);
  const std::size_t begin = html.find("<script>");
  html.erase(begin, html.find("</script>") + 9 - begin);
  return html;
}

TEST(StudyReport, IsWellFormed) { EXPECT_EQ(wrongly_nested(page(made_up_study())), ""); }

TEST(StudyReport, NeedsNothingFromElsewhere) {
  const std::string html = report_html(made_up_study());
  for (const char* reference : {"http", "url(", "@import", "<link", "src=\"/", "<iframe"}) {
    EXPECT_EQ(count(html, reference), 0u) << reference;
  }
  EXPECT_EQ(count(html, "prefers-color-scheme: dark"), 1u);
}

TEST(StudyReport, EveryFigureHasALineForEveryScheme) {
  const std::string html = report_html(made_up_study());
  // Difference three times, FLIP twice, queue and bound; then the legends, which are drawn as lines too.
  for (const char* line : {"line line0\"", "line line1\"", "line line2\""}) EXPECT_GE(count(html, line), 14u) << line;
  // Rays by type: of each scheme a plot, with the two kinds that the scene has.
  EXPECT_EQ(count(html, "<title>primary</title>"), 3u);
  EXPECT_EQ(count(html, "<title>shadow</title>"), 3u);
  EXPECT_EQ(count(html, "<title>reflection</title>"), 0u);
}

TEST(StudyReport, NamesAreText) {
  const std::string html = page(made_up_study());
  EXPECT_GE(count(html, "region(0,0,9,9), level&lt;2"), 8u);
  EXPECT_EQ(count(html, "level<2"), 0u);
  EXPECT_GE(count(html, "room &amp; garden.pov"), 2u);
}

TEST(StudyReport, TellsWhatWasMeasured) {
  const std::string html = report_html(made_up_study());
  EXPECT_EQ(count(html, "40 x 25 pixels, 3 light sources, 5 levels, 1 thread."), 1u);
  EXPECT_EQ(count(html, "4000 rays: 1000 primary, 0 reflection, 0 transmission, 3000 shadow."), 1u);
  // Paired: 1.5 / 2 in every round.
  EXPECT_EQ(count(html, ">0.75 <span class=\"soft\">(0.75 to 0.75)</span>"), 1u);
  EXPECT_EQ(count(html, "25.00 %"), 3u) << "of the worst case";
  EXPECT_GE(count(html, "&ndash;"), 3u) << "no scheme has a first image";
}

TEST(StudyReport, ShowsThePictures) {
  Study study = made_up_study();
  study.schemes[1].pictures.push_back({0.05, 0.12, 0.345, "not a PNG"});
  const std::string html = report_html(study);
  EXPECT_EQ(count(html, "src=\"data:image/png;base64,bm90IGEgUE5H\""), 1u);
  EXPECT_EQ(count(html, "5 % of the rays<br>0.120 s, 34.5 % off"), 1u);
}

TEST(StudyCsv, HasAFileForEachFigure) {
  std::map<std::string, std::string> files;
  for (const CsvFile& file : csv_files(made_up_study())) files[file.name] = file.text;
  ASSERT_EQ(files.size(), 7u);
  for (const char* name : {"rays_by_type.csv", "queue.csv", "difference.csv", "flip.csv", "bound.csv"}) {
    EXPECT_EQ(std::ranges::count(files.at(name), '\n'), 301) << name << ": a heading and 100 moments of 3 schemes";
  }
  EXPECT_TRUE(files.at("difference.csv")
                  .starts_with("scheme,seconds,share_of_rays,difference\n"
                               "recursive,0.02000,0.01000,0.990000\n"));
  EXPECT_NE(files.at("queue.csv").find("\"region(0,0,9,9), level<2\",1.50000,250,16000\n"), std::string::npos);
  EXPECT_NE(files.at("rays_by_type.csv").find("contribution,0.75000,500,0,0,1500\n"), std::string::npos);
  EXPECT_EQ(std::ranges::count(files.at("rounds.csv"), '\n'), 10);
}

TEST(StudyCsv, EveryRowHasTheHeadingsColumns) {
  Study study = made_up_study();
  study.schemes.pop_back();  // whose name holds commas
  for (const CsvFile& file : csv_files(study)) {
    std::istringstream lines(file.text);
    std::string line;
    std::getline(lines, line);
    const auto columns = std::ranges::count(line, ',');
    while (std::getline(lines, line)) EXPECT_EQ(std::ranges::count(line, ','), columns) << file.name << ": " << line;
  }
}

TEST(StudyCsv, QuotesWhatNeedsThem) {
  EXPECT_EQ(csv_field("level"), "level");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"a\""), "\"say \"\"a\"\"\"");
}

// RFC 4648, section 10.
TEST(Thumbnail, Base64IsTheStandards) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Thumbnail, PixelsAreMeans) {
  const std::vector<render::Rgb> colors{render::Rgb(0.0f), render::Rgb(1.0f), render::Rgb(0.5f), render::Rgb(7.0f),
                                        render::Rgb(0.0f), render::Rgb(1.0f), render::Rgb(0.5f), render::Rgb(-1.0f)};
  const SmallPicture small = shrink(colors, 4, 2, 2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  EXPECT_EQ(small.colors[0], render::Rgb(0.5f));
  EXPECT_EQ(small.colors[1], render::Rgb(0.5f)) << "clipped before they are averaged";
}

TEST(Thumbnail, SmallPicturesStayAsTheyAre) {
  const std::vector<render::Rgb> colors{render::Rgb(0.1f), render::Rgb(0.2f), render::Rgb(0.3f)};
  const SmallPicture small = shrink(colors, 1, 3, 200);
  EXPECT_EQ(small.width, 1);
  EXPECT_EQ(small.height, 3);
  EXPECT_EQ(small.colors, colors);
}

TEST(Thumbnail, AnySizeFits) {
  const std::vector<render::Rgb> colors(1000 * 3, render::Rgb(0.25f));
  const SmallPicture small = shrink(colors, 1000, 3, 100);
  EXPECT_EQ(small.width, 100);
  EXPECT_EQ(small.height, 1);
  for (const render::Rgb& color : small.colors) EXPECT_NEAR(color.x, 0.25f, 1e-6f);
}

}  // namespace
}  // namespace firstlight::app
