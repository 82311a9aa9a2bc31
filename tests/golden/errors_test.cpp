// Scenes with a mistake: each says itself, in a comment, what must be said about it and where.

#include "tests/golden/refusal.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

/// The number of the line that gives this error: `.../part.inc:2:5: error: ...message...`.
std::optional<std::size_t> find_error(const std::vector<std::string>& lines, const ExpectedError& error) {
  const std::string place = fmt::format("{}:{}:{}: error: ", error.file, error.line, error.column);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t at = lines[i].find(place);
    if (at != std::string::npos && lines[i].find(error.message, at + place.size()) != std::string::npos) return i;
  }
  return std::nullopt;
}

std::string source_line(const fs::path& file, int number) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(stream, line);
  while (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

class BadScene : public testing::TestWithParam<fs::path> {};

TEST_P(BadScene, SaysWhatItsCommentExpects) {
  const fs::path& scene = GetParam();
  const auto expected = expected_errors(scene);
  ASSERT_FALSE(expected.empty()) << scene << " does not say which error it expects";
  const ScratchFolder scratch;
  const ProcessResult result = expect_refusal(scene, scratch);
  const auto lines = lines_of(result.err);
  for (const ExpectedError& error : expected) {
    const auto at = find_error(lines, error);
    ASSERT_TRUE(at) << "expected " << error.file << ':' << error.line << ':' << error.column << ": error: ..."
                    << error.message << "... in:\n"
                    << result.err.substr(0, 3000);
    // The line of the scene follows, then a caret below the column.
    ASSERT_LT(*at + 2, lines.size()) << "no source line and caret after:\n" << lines[*at];
    EXPECT_NE(lines[*at + 1].find(source_line(scene.parent_path() / error.file, error.line)), std::string::npos)
        << lines[*at + 1];
    EXPECT_NE(lines[*at + 2].find('^'), std::string::npos) << lines[*at + 2];
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadScene, testing::ValuesIn(error_scenes()),
                         [](const auto& info) { return test_name(info.param.stem().string()); });

}  // namespace
}  // namespace firstlight::golden
