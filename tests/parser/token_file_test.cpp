// Files that give up pages of tokens read as those that keep them all.
#include "parser/text/token_file.h"

#include "parser/text/syntax_error.h"
#include "tests/parser/evaluated.h"

#include <algorithm>
#include <iterator>
#include <random>
#include <string>

namespace firstlight::parser {
namespace {

constexpr PageBudget kWhole{std::size_t{1} << 30, 12, 64};

SourceFile source_of(std::string text) {
  SourceFile source;
  source.name = "test.pov";
  source.text = std::move(text);
  source.line_starts = {0};
  for (std::uint32_t i = 0; i < source.text.size(); ++i) {
    if (source.text[i] == '\n') source.line_starts.push_back(i + 1);
  }
  return source;
}

/// All that a text can have, with strings and comments of several lines.
std::string varied_text() {
  std::string text = "\xef\xbb\xbf#version 3.7;\n";
  for (int i = 0; i < 60; ++i) {
    const std::string number = std::to_string(i);
    text += "#declare Name" + number + " = " + number + ".5e-3; // to the end of the line \xfc\n";
    text += "#if (Name" + number + " <= 4) /* one\n /* two */ */ #declare Text = \"a\\\"b\nc\"; #else\r\n\t";
    text += "#for (I, 1, 3) sphere { <I, 0, 0>, 1 } #end #end\n";
    text += "#switch (2) #case (1) #break #range (2, 3) box { -1, 1 } #else #end\n";
  }
  return text;
}

void expect_equal(const Token& a, const Token& b, std::size_t index) {
  EXPECT_EQ(a.kind, b.kind) << index;
  EXPECT_EQ(a.punctuation, b.punctuation) << index;
  EXPECT_EQ(a.keyword, b.keyword) << index;
  EXPECT_EQ(a.symbol, b.symbol) << index;
  EXPECT_EQ(a.number, b.number) << index;
  EXPECT_EQ(a.text, b.text) << index;
  EXPECT_EQ(a.text.data(), b.text.data()) << index;
  EXPECT_EQ(a.location.line, b.location.line) << index;
  EXPECT_EQ(a.location.column, b.location.column) << index;
  EXPECT_EQ(a.location.length, b.location.length) << index;
}

TEST(TokenFile, TokensAreTheSameWhateverIsKept) {
  const SourceFile source = source_of(varied_text());
  Symbols symbols;
  const TokenFile whole(source, symbols, kWhole);
  for (const PageBudget budget : {PageBudget{0, 0, 1}, PageBudget{0, 2, 1}, PageBudget{0, 3, 2}, PageBudget{0, 5, 7},
                                  PageBudget{100, 4, 3}, PageBudget{whole.size() - 1, 6, 2}, PageBudget{0, 16, 1}}) {
    const TokenFile paged(source, symbols, budget);
    ASSERT_EQ(paged.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) expect_equal(paged[i], whole[i], i);
    for (std::size_t i = whole.size(); i-- > 0;) expect_equal(paged[i], whole[i], i);
    std::minstd_rand random(1);
    for (int turn = 0; turn < 1000; ++turn) {
      const std::size_t i = random() % whole.size();
      expect_equal(paged[i], whole[i], i);
    }
    EXPECT_TRUE(paged.back().is_end());
  }
}

TEST(TokenFile, LinksNeedNoTokens) {
  const SourceFile source = source_of(varied_text());
  Symbols symbols;
  const TokenFile file(source, symbols, PageBudget{0, 2, 1});
  std::size_t blocks = 0;
  for (std::uint32_t i = 0; i + 1 < file.size(); ++i) {
    const bool opens = file[i].is(Punctuation::hash) && opens_block(file[i + 1].keyword);
    blocks += opens;
    if (!opens) continue;
    const std::uint32_t end = end_of_block(file, i);
    ASSERT_TRUE(file[end].is(Punctuation::hash));
    EXPECT_TRUE(file[end + 1].is(Keyword::end));
    EXPECT_EQ(file.link(end), kNoLink);
    std::uint32_t part = i;
    while (part != end) {
      EXPECT_GT(file.link(part), part);
      part = file.link(part);
    }
  }
  EXPECT_EQ(blocks, 180u);
  EXPECT_EQ(file.link(1), kNoLink);
  EXPECT_EQ(end_of_block(file, 1), kNoLink);
}

TEST(TokenFile, MistakesAreFoundAtOnceWhereverTheyAre) {
  const auto error_of = [](const std::string& text) -> std::string {
    const SourceFile source = source_of(text);
    Symbols symbols;
    try {
      const TokenFile file(source, symbols, PageBudget{0, 2, 1});
    } catch (const SyntaxError& error) {
      std::string all;
      for (const auto& message : error.diagnostics) {
        all += std::to_string(message.line) + ":" + std::to_string(message.column) + ": " + message.message + "\n";
      }
      return all;
    }
    return "no error";
  };
  const std::string start(1000, '\n');
  const std::string numbers = start + "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 ";
  EXPECT_EQ(error_of(numbers + "\"a"), "1001:43: expected '\"' to end the string, found end of file\n");
  EXPECT_EQ(error_of(numbers + "1.2.3"), "1001:43: expected a number, found one with a second '.'\n");
  EXPECT_EQ(error_of(numbers + "/* 1"), "1001:43: expected '*/' to close the comment, found end of file\n");
  EXPECT_EQ(error_of("#for (I, 1, 2)\n" + numbers + "#if (1)\n\n"),
            "1004:1: expected '#end' to close '#for', found end of file\n1:2: '#for' opened here\n");
}

/// So many tokens that their file gives up pages, in lines of ten.
std::string very_many_tokens() {
  std::string text;
  for (int i = 0; i < 110'000; ++i) text += "1 2 3 4 5 6 7 8 9 10\n";
  return text;
}

TEST(TokenFile, ALargeSceneIsReadAsASmallOne) {
  const std::string begin =
      "#macro Add(N) #declare Sum = Sum + N; #if (N = 2) #declare Twos = Twos + 1; #else #declare Others = Others + 1;"
      " #end #end\n#declare Sum = 0; #declare Twos = 0; #declare Others = 0;\n";
  std::string loop = "#for (I, 1, 3)\n";
  for (int i = 0; i < 3000; ++i) loop += "Add(I) #if (I > 2) #declare Sum = Sum + 1; #else #end\n";
  loop += "#end #debug concat(str(Sum, 0, 0), \" \", str(Twos, 0, 0), \" \", str(Others, 0, 0))";
  EXPECT_EQ(debugged(begin + loop), "21000 3000 6000");
  EXPECT_EQ(debugged(begin + "#if (0)\n" + very_many_tokens() + "#end\n" + loop), "21000 3000 6000");
}

TEST(TokenFile, AMistakeFarBehindHasItsPlace) {
  const std::string skipped = "#if (0)\n" + very_many_tokens() + "#end\n";
  const auto result =
      load("#declare A = 1;\n" + skipped + skipped + "#declare B = A;\n  sphere { 0, 1 } torus { 1, C }");
  ASSERT_EQ(errors(result), "expected a numeric expression, found undeclared identifier 'C'\n");
  EXPECT_EQ(result.diagnostics.front().line, 220'007u);
  EXPECT_EQ(result.diagnostics.front().column, 30u);
  EXPECT_EQ(result.diagnostics.front().source_line, "  sphere { 0, 1 } torus { 1, C }");
}

TEST(TokenFile, AListOfVeryManyNumbersIsReadWhole) {
  constexpr int kCorners = 200'000;
  std::string text = "mesh2 { vertex_vectors { " + std::to_string(kCorners);
  for (int i = 0; i < kCorners; ++i) text += ",\n<" + std::to_string(i) + ", " + std::to_string(i % 7) + ", 0.5>";
  text += " } face_indices { 1, <0, 1, " + std::to_string(kCorners - 1) + "> } }";
  const auto scene = scene_of(text);
  ASSERT_EQ(scene->solids.size(), 1u);
  EXPECT_GE(scene->solids[0].box().max.x, kCorners - 1);
}

}  // namespace
}  // namespace firstlight::parser
