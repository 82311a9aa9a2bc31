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

/// Nothing at the end of the file, where there is no line.
std::optional<std::string> source_line(const fs::path& file, int number) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < number; ++i) {
    if (!std::getline(stream, line)) return std::nullopt;
  }
  while (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

/// `error.file` is in the folder of the scene or below it.
fs::path file_of(const ExpectedError& error, const fs::path& scene) {
  for (const auto& entry : fs::recursive_directory_iterator(scene.parent_path())) {
    if (entry.path().filename() == error.file) return entry.path();
  }
  return scene;
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
    const auto source = source_line(file_of(error, scene), error.line);
    if (!source) continue;
    ASSERT_LT(*at + 2, lines.size()) << "no source line and caret after:\n" << lines[*at];
    EXPECT_TRUE(lines[*at + 1].ends_with(*source)) << lines[*at + 1];
    const std::size_t text_begins = lines[*at + 1].size() - source->size();
    EXPECT_EQ(lines[*at + 2].find('^'), text_begins + static_cast<std::size_t>(error.column) - 1) << lines[*at + 2];
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadScene, testing::ValuesIn(error_scenes()),
                         [](const auto& info) { return test_name(info.param.stem().string()); });

}  // namespace
}  // namespace firstlight::golden
