// Expressions have the values that POV-Ray gives them: both write them with #debug, and the texts are compared.
#include "tests/parser/agreement_table.h"
#include "tests/parser/evaluated.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::parser {
namespace {

/// The text from each mark to its ';', without white space: POV-Ray breaks long lines, and warns between them.
std::vector<std::string> values_in(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  std::vector<std::string> values;
  for (std::size_t at = text.find(kMark); at != std::string::npos;) {
    const std::size_t next = text.find(kMark, at + 1);
    const std::size_t end = std::min(text.find(';', at), next);
    values.push_back(text.substr(at + 1, end == std::string::npos ? end : end - at - 1));
    at = next;
  }
  return values;
}

constexpr std::string_view kBegin =
    "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n";

/// POV-Ray's messages when it reads the scene; it need not render it.
std::string povray_says(const std::string& scene) {
  const SceneFile file(std::string(kBegin) + scene + "#debug \"~\\n\"\n#error \"done\"\n");
  const std::string command = "povray +I" + file.path() + " -D -GR -GS +W320 +H240 -F 2>&1 < /dev/null";
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> buffer{};
  for (std::size_t read = 0; (read = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), read);
  pclose(pipe);
  return text;
}

std::string firstlight_says(const std::string& scene) {
  const auto result = load_bare(std::string(kBegin) + scene);
  EXPECT_EQ(errors(result), "");
  return messages(result, render::Diagnostic::Severity::debug) + std::string(kMark);
}

void expect_agreement(const std::string& name, std::size_t least) {
  const Table table = read_table(name);
  ASSERT_GE(table.expressions.size(), least);
  const std::string povray_text = povray_says(table.scene);
  const std::vector<std::string> theirs = values_in(povray_text), ours = values_in(firstlight_says(table.scene));
  ASSERT_EQ(theirs.size(), table.expressions.size() + 1)
      << povray_text.substr(povray_text.size() - std::min<std::size_t>(povray_text.size(), 500));
  ASSERT_EQ(ours.size(), table.expressions.size() + 1);
  for (std::size_t i = 0; i < table.expressions.size(); ++i) EXPECT_EQ(ours[i], theirs[i]) << table.expressions[i];
}

TEST(Agreement, ExpressionsHaveTheValuesThatPovRayGivesThem) { expect_agreement("agreement.txt", 400); }
TEST(Agreement, MacrosOfTheStandardIncludesGiveWhatTheyGiveInPovRay) { expect_agreement("include_macros.txt", 120); }

TEST(Agreement, RandomNumbersAreThoseOfPovRay) {
  std::string scene;
  for (const char* seed : {"0", "1", "12345", "-7", "2147483647"}) {
    scene += "#declare R = seed(" + std::string(seed) +
             "); #declare I = 0; #while (I < 1000) #debug concat(\"~\", str(rand(R), 0, 17), \";\\n\")"
             " #declare I = I + 1; #end\n";
  }
  std::vector<std::string> theirs = values_in(povray_says(scene)), ours = values_in(firstlight_says(scene));
  ASSERT_EQ(theirs.size(), 5001u);
  theirs.pop_back();  // the mark at the end
  ours.pop_back();
  const auto [our, their] = std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end());
  if (our != ours.end() && their != theirs.end()) {
    EXPECT_EQ(*our, *their) << "number " << our - ours.begin();
  }
  EXPECT_EQ(ours.size(), theirs.size());
}

}  // namespace
}  // namespace firstlight::parser
