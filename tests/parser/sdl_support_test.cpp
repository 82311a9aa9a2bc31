// docs/sdl-support.md is made here, from the table of reserved words and from the tests that use them. To write it
// anew: FIRSTLIGHT_WRITE_DOCS=1 firstlight_parser_test --gtest_filter='SdlSupport.*'

#include "parser/text/token.h"
#include "render/feature/feature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::parser {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = FIRSTLIGHT_SOURCE_DIR;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::set<std::string> words_of(std::string_view text) {
  std::set<std::string> words;
  std::string word;
  for (const char c : std::string(text) + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// The text that a C++ source has between quotation marks, raw or not: the scenes that a test reads.
std::string strings_of(const std::string& source) {
  std::string strings;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.compare(i, 2, "//") == 0) {
      i = std::min(source.find('\n', i), source.size());
    } else if (source.compare(i, 2, "R\"") == 0) {
      const std::size_t open = source.find('(', i);
      const std::string close = ")" + source.substr(i + 2, open - i - 2) + "\"";
      const std::size_t end = source.find(close, open);
      strings += source.substr(open + 1, end - open - 1) + ' ';
      i = end + close.size() - 1;
    } else if (source[i] == '\'') {
      i += source[i + 1] == '\\' ? 3 : 2;
    } else if (source[i] == '"') {
      for (++i; source[i] != '"'; ++i) {
        if (source[i] == '\\') {
          ++i;
          strings += ' ';
        } else {
          strings += source[i];
        }
      }
      strings += ' ';
    }
  }
  return strings;
}

std::vector<fs::path> files_below(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().string().ends_with(ending)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// For each word the first file that uses it, by its path in the repository.
using Uses = std::map<std::string, std::string>;

void note(Uses& uses, const fs::path& file, std::string_view text) {
  for (const std::string& word : words_of(text)) uses.emplace(word, fs::relative(file, kSource).string());
}

Uses uses_in_pictures() {
  Uses uses;
  for (const fs::path& scene : files_below(kSource / "testscenes", ".pov")) note(uses, scene, text_of(scene));
  return uses;
}

Uses uses_in_tests() {
  Uses uses;
  for (const fs::path& test : files_below(kSource / "tests" / "parser", ".cpp")) {
    if (test.filename() != "sdl_support_test.cpp" && test.filename() != "include_name_test.cpp")
      note(uses, test, strings_of(text_of(test)));
  }
  for (const fs::path& table : files_below(kSource / "tests" / "parser", ".txt")) note(uses, table, text_of(table));
  return uses;
}

/// Words of features that no picture shows: alone in the feature's name, or with others.
struct Unrendered {
  std::set<std::string> alone, among_others;
};

Unrendered unrendered() {
  constexpr render::Feature kFeatures[] = {
#define FEATURE(name, spelling, rendered) render::Feature::name,
#include "render/feature/features.def"
#undef FEATURE
  };
  Unrendered result;
  for (const render::Feature feature : kFeatures) {
    if (render::is_rendered(feature)) continue;
    const std::set<std::string> words = words_of(render::spelling(feature));
    (words.size() == 1 ? result.alone : result.among_others).insert(words.begin(), words.end());
  }
  return result;
}

struct Row {
  std::string word, state, where;
};

std::optional<std::string> find(const Uses& uses, const std::string& word) {
  const auto found = uses.find(word);
  return found == uses.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Row> rows() {
  const Uses pictures = uses_in_pictures();
  const Uses tests = uses_in_tests();
  const Unrendered missing = unrendered();
  std::vector<Row> rows;
  constexpr std::string_view kWords[] = {
#define KEYWORD(name, spelling) spelling,
#define KEYWORD_SYNONYM(name, spelling) spelling,
#include "parser/keywords.def"
#undef KEYWORD_SYNONYM
#undef KEYWORD
  };
  for (const std::string_view spelling : kWords) {
    const std::string word(spelling);
    const auto picture = find(pictures, word);
    const auto test = find(tests, word);
    if (missing.alone.contains(word) || (missing.among_others.contains(word) && !picture)) {
      rows.push_back({word, "read, not rendered", test.value_or(picture.value_or(""))});
    } else if (picture) {
      rows.push_back({word, "rendered", *picture});
    } else {
      rows.push_back({word, "read", test.value_or("")});
    }
  }
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.word < b.word; });
  return rows;
}

std::string page() {
  const std::vector<Row> all = rows();
  const auto count = [&](std::string_view state) {
    return std::to_string(std::count_if(all.begin(), all.end(), [&](const Row& row) { return row.state == state; }));
  };
  std::string text =
      "# The reserved words of the scene language\n\n"
      "Made by a test from the table of words and from the tests that use them; not to be written by hand.\n\n"
      "- **rendered** (" +
      count("rendered") +
      "): used by a scene whose picture is compared with POV-Ray's.\n"
      "- **read** (" +
      count("read") +
      "): read with its meaning and tested; it decides what a scene is, or makes no "
      "difference to a picture.\n"
      "- **read, not rendered** (" +
      count("read, not rendered") +
      "): read into the scene's description; a scene in "
      "which it counts is refused with its place, and `--parse-only` lists it.\n\n"
      "| word | state | tested by |\n|---|---|---|\n";
  for (const Row& row : all) text += "| `" + row.word + "` | " + row.state + " | " + row.where + " |\n";
  return text;
}

TEST(SdlSupport, EveryReservedWordIsUsedByATest) {
  for (const Row& row : rows()) EXPECT_FALSE(row.where.empty()) << "no test's scene uses '" << row.word << "'";
}

TEST(SdlSupport, PageIsUpToDate) {
  const fs::path file = kSource / "docs" / "sdl-support.md";
  const std::string made = page();
  if (std::getenv("FIRSTLIGHT_WRITE_DOCS") != nullptr) std::ofstream(file, std::ios::binary) << made;
  EXPECT_TRUE(text_of(file) == made) << "docs/sdl-support.md is not what the tests say; write it anew with\n"
                                        "FIRSTLIGHT_WRITE_DOCS=1 firstlight_parser_test --gtest_filter='SdlSupport.*'";
}

TEST(SdlSupport, SourcesAreReadAsTheCompilerReadsThem) {
  EXPECT_EQ(words_of(strings_of("f(\"sphere \\\"box\", R\"x(cone)x\", '\"', torus); // \"plane\"\n")),
            (std::set<std::string>{"sphere", "box", "cone"}));
}

}  // namespace
}  // namespace firstlight::parser
