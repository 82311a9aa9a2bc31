#include "parser/text/lexer.h"

#include "parser/text/syntax_error.h"

#include <gtest/gtest.h>

namespace firstlight::parser {
namespace {

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

/// The tokens of a text, with what they point into.
struct Cut {
  explicit Cut(std::string text) : source(source_of(std::move(text))), file(source, symbols) {}
  Token operator[](std::size_t i) const { return file[i]; }
  std::size_t size() const { return file.size() - 1; }  // without the end

  Symbols symbols;
  SourceFile source;
  TokenFile file;
};

std::string error_of(std::string text) {
  try {
    const Cut cut(std::move(text));
  } catch (const SyntaxError& error) {
    const auto& first = error.diagnostics.front();
    return std::to_string(first.line) + ":" + std::to_string(first.column) + ": " + first.message;
  }
  return "no error";
}

TEST(Lexer, TellsKeywordsFromIdentifiers) {
  const Cut cut("sphere Sphere");
  EXPECT_TRUE(cut[0].is(Keyword::sphere));
  EXPECT_EQ(cut[1].kind, TokenKind::identifier);
}

TEST(Lexer, ColourAndColorAreOneKeyword) {
  const Cut cut("colour color colour_map color_map");
  EXPECT_EQ(cut[0].keyword, cut[1].keyword);
  EXPECT_EQ(cut[2].keyword, cut[3].keyword);
}

TEST(Lexer, EqualIdentifiersHaveEqualSymbols) {
  const Cut cut("Foo Bar Foo");
  EXPECT_EQ(cut[0].symbol, cut[2].symbol);
  EXPECT_NE(cut[0].symbol, cut[1].symbol);
}

TEST(Lexer, ReadsNumbersInEveryForm) {
  const Cut cut("7 .5 5. 1e-3 2.5E2");
  EXPECT_EQ(cut[0].number, 7.0);
  EXPECT_EQ(cut[1].number, 0.5);
  EXPECT_EQ(cut[2].number, 5.0);
  EXPECT_EQ(cut[3].number, 0.001);
  EXPECT_EQ(cut[4].number, 250.0);
}

TEST(Lexer, APointBeforeALetterIsAMark) {
  const Cut cut("V.x");
  EXPECT_TRUE(cut[1].is(Punctuation::period));
  EXPECT_TRUE(cut[2].is(Keyword::x));
}

TEST(Lexer, JoinsTwoCharacterComparisons) {
  const Cut cut("<= >= != < =");
  EXPECT_TRUE(cut[0].is(Punctuation::less_equal));
  EXPECT_TRUE(cut[1].is(Punctuation::greater_equal));
  EXPECT_TRUE(cut[2].is(Punctuation::not_equal));
  EXPECT_TRUE(cut[3].is(Punctuation::less));
  EXPECT_TRUE(cut[4].is(Punctuation::equal));
}

TEST(Lexer, CommentsNest) {
  const Cut cut("a /* b /* c */ d */ e // f\ng");
  ASSERT_EQ(cut.size(), 3u);
  EXPECT_EQ(cut[1].text, "e");
  EXPECT_EQ(cut[2].text, "g");
}

TEST(Lexer, CountsLinesAndColumnsFromOne) {
  const Cut cut("a\r\n  box");
  EXPECT_EQ(cut[1].location.line, 2u);
  EXPECT_EQ(cut[1].location.column, 3u);
  EXPECT_EQ(cut[1].location.length, 3u);
}

TEST(Lexer, PassesOverAByteOrderMark) {
  const Cut cut(
      "\xef\xbb\xbf"
      "box");
  EXPECT_TRUE(cut[0].is(Keyword::box));
}

TEST(Lexer, AcceptsOtherBytesInCommentsAndStrings) {
  const Cut cut("// gr\xfc\xdf\n\"gr\xfc\xdf\"");
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].text, "gr\xfc\xdf");
}

TEST(Lexer, RefusesOtherBytesElsewhere) {
  EXPECT_EQ(error_of("box\n \xfc"), "2:2: expected scene text, found a character that is not allowed here (byte 0xfc)");
}

TEST(Lexer, RefusesABinaryFile) {
  EXPECT_EQ(error_of(std::string("box\0{", 5)), "0:0: expected scene text, found a binary file");
}

TEST(Lexer, AnOpenCommentIsReportedWhereItBegins) {
  EXPECT_EQ(error_of("box /* x"), "1:5: expected '*/' to close the comment, found end of file");
}

TEST(Lexer, AnOpenStringIsReportedWhereItBegins) {
  EXPECT_EQ(error_of("a \"bc"), "1:3: expected '\"' to end the string, found end of file");
}

TEST(Lexer, AStringMayHoldAQuote) { EXPECT_EQ(Cut(R"("a\"b" c)")[0].text, R"(a\"b)"); }

TEST(Lexer, ANumberHasOnePoint) { EXPECT_EQ(error_of("1.2.3"), "1:1: expected a number, found one with a second '.'"); }

TEST(Lexer, LinksTheBranchesOfABlock) {
  const Cut cut("#if (1) #if (2) #end #else 3 #end");
  const std::uint32_t branch = cut.file.link(0);
  EXPECT_TRUE(cut[branch + 1].is(Keyword::else_));
  EXPECT_TRUE(cut[cut.file.link(branch) + 1].is(Keyword::end));
}

TEST(Lexer, ABlockWithoutEndIsAnError) {
  EXPECT_EQ(error_of("#while (1)\nbox"), "2:4: expected '#end' to close '#while', found end of file");
}

TEST(Lexer, AnEmptyTextIsJustItsEnd) {
  const Cut cut("");
  EXPECT_EQ(cut.size(), 0u);
  EXPECT_TRUE(cut[0].is_end());
}

}  // namespace
}  // namespace firstlight::parser
