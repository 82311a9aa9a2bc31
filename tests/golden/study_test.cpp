// `firstlight study`: the report of a small run, and what is refused.

#include "tests/golden/picture.h"
#include "tests/golden/render.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kRoom = testscenes() / "full" / "mirror_room.pov";

ProcessResult study(const std::vector<std::string>& arguments, const ScratchFolder& scratch) {
  std::vector<std::string> command{program_under_test(), "study"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, scratch.path(), scratch.path(), kRenderLimit);
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// The page without the letters that its pictures are written in, which spell anything by chance.
std::string without_pictures(const std::string& page) {
  static const std::string kPicture = "data:image/png;base64,";
  std::string rest;
  std::size_t from = 0;
  for (std::size_t at = page.find(kPicture); at != std::string::npos; at = page.find(kPicture, from)) {
    rest.append(page, from, at - from);
    from = std::min(page.find('"', at), page.size());
  }
  return rest.append(page, from);
}

struct Row {
  std::string scheme;
  std::vector<double> numbers;  ///< behind the scheme
};

/// The rows of schemes whose names need no quotes.
std::vector<Row> rows_of(const fs::path& csv) {
  std::vector<Row> rows;
  std::istringstream lines(text_of(csv));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    Row row;
    std::istringstream fields(line);
    std::string field;
    std::getline(fields, row.scheme, ',');
    while (std::getline(fields, field, ',')) {
      double number = 0.0;
      std::from_chars(field.data(), field.data() + field.size(), number);
      row.numbers.push_back(number);
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(Study, ReportsOnTheSchemesItIsGiven) {
  const ScratchFolder scratch;
  const ProcessResult result = study({kRoom.string(), "+W96", "+H72", "--threads", "2", "--out", "report", "--rounds",
                                      "2", "--schemes", "recursive; contribution; ray-type"},
                                     scratch);
  ASSERT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  EXPECT_NE(result.err.find("report/index.html"), std::string::npos) << result.err;

  const std::string page = text_of(scratch / "report/index.html");
  EXPECT_NE(page.find("mirror_room.pov"), std::string::npos);
  EXPECT_EQ(count(page, "data:image/png;base64,"), 18u) << "six moments of three schemes";
  EXPECT_EQ(count(without_pictures(page), "http"), 0u) << "nothing from elsewhere";

  // Every curve falls from the black picture to the finished one, and the moments are in order.
  std::map<std::string, std::vector<std::vector<double>>> curves;
  for (const Row& row : rows_of(scratch / "report/difference.csv")) curves[row.scheme].push_back(row.numbers);
  ASSERT_EQ(curves.size(), 3u);
  for (const auto& [scheme, moments] : curves) {
    SCOPED_TRACE(scheme);
    EXPECT_GE(moments.size(), 20u);
    EXPECT_LT(moments.front()[1], 0.2) << "the first look comes soon";
    for (std::size_t i = 1; i < moments.size(); ++i) {
      EXPECT_GE(moments[i][0], moments[i - 1][0]) << "seconds";
      EXPECT_GE(moments[i][1], moments[i - 1][1]) << "share of the rays";
    }
    EXPECT_EQ(moments.back()[1], 1.0);
    EXPECT_EQ(moments.back()[2], 0.0);
  }
  for (const Row& row : rows_of(scratch / "report/flip.csv")) {
    EXPECT_GE(row.numbers[2], 0.0);
    EXPECT_LE(row.numbers[2], 1.0);
  }

  // The traditional order is half done at half time; what matters first comes much sooner.
  std::map<std::string, std::vector<double>> summary;
  for (const Row& row : rows_of(scratch / "report/summary.csv")) summary[row.scheme] = row.numbers;
  constexpr std::size_t kArea = 6;
  EXPECT_GT(summary.at("recursive")[kArea], 0.35);
  EXPECT_LT(summary.at("contribution")[kArea], 0.5 * summary.at("recursive")[kArea]);
  EXPECT_EQ(rows_of(scratch / "report/rounds.csv").size(), 6u);
}

TEST(Study, AllSchemesWorkWithAnyScene) {
  const ScratchFolder scratch;
  const ProcessResult result = study({(testscenes() / "interior" / "refraction.pov").string(), "+W40", "+H30",
                                      "--rounds", "1", "-o", "all", "--quiet"},
                                     scratch);
  ASSERT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  EXPECT_EQ(result.err, "");
  const std::string page = text_of(scratch / "all/index.html");
  for (const char* scheme : {"recursive", "contribution", "level", "ray-type", "0.7*contribution + 0.3*level"}) {
    EXPECT_GE(count(page, scheme), 8u) << scheme;
  }
}

TEST(Study, AnUnknownSchemeIsNamed) {
  const ScratchFolder scratch;
  const ProcessResult result = study({kRoom.string(), "--schemes", "recursive;levle"}, scratch);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("levle"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::is_empty(scratch.path())) << "no folder is made for nothing";
}

TEST(Study, AFolderThatCannotBeMadeIsNamed) {
  const ScratchFolder scratch;
  scratch.write("taken", "a file");
  const ProcessResult result = study({kRoom.string(), "+W20", "+H20", "--out", "taken"}, scratch);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("taken"), std::string::npos) << result.err;
  EXPECT_EQ(text_of(scratch / "taken"), "a file");
}

TEST(Study, HelpTellsOfIt) {
  const ScratchFolder scratch;
  const ProcessResult result = study({"--help"}, scratch);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.out.find("firstlight study SCENE.pov"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace firstlight::golden
