#include "render/scene/diagnostic.h"

#include <gtest/gtest.h>

namespace firstlight::render {
namespace {

Diagnostic example() {
  Diagnostic d;
  d.file = "scene.pov";
  d.line = 4;
  d.column = 1;
  d.length = 3;
  d.message = "expected '}' to close 'sphere', found 'box'";
  d.source_line = "box { 0, 1 }";
  return d;
}

TEST(Diagnostic, ShowsThePlaceTheMessageAndTheUnderlinedWord) {
  EXPECT_EQ(format(example()),
            "scene.pov:4:1: error: expected '}' to close 'sphere', found 'box'\n"
            "  4 | box { 0, 1 }\n"
            "    | ^~~");
}

TEST(Diagnostic, OfAFileAsAWholeHasNoLine) {
  Diagnostic d;
  d.severity = Diagnostic::Severity::warning;
  d.file = "scene.pov";
  d.message = "no camera";
  EXPECT_EQ(format(d), "scene.pov: warning: no camera");
}

TEST(Diagnostic, TabsAndControlBytesTakeOneColumn) {
  Diagnostic d = example();
  d.source_line = "\t\x1b[box";
  d.column = 4;
  EXPECT_EQ(format(d),
            "scene.pov:4:4: error: expected '}' to close 'sphere', found 'box'\n"
            "  4 |  ?[box\n"
            "    |    ^~~");
}

TEST(Diagnostic, CaretStandsBelowItsPlaceAfterLettersOfSeveralBytes) {
  Diagnostic d = example();
  d.source_line = "\"\u00e4\u00f6\" box";
  d.column = 8;
  EXPECT_EQ(format(d),
            "scene.pov:4:8: error: expected '}' to close 'sphere', found 'box'\n"
            "  4 | \"\u00e4\u00f6\" box\n"
            "    |      ^~~");
}

TEST(Diagnostic, PlaceAtOrBehindTheEndOfTheLineIsShownThere) {
  Diagnostic d = example();
  for (const std::size_t column : {std::size_t{13}, std::size_t{500}}) {
    d.column = column;
    const std::string text = format(d);
    EXPECT_EQ(text.substr(text.rfind('\n')), "\n    |             ^");
  }
}

TEST(Diagnostic, WhatSteersATerminalIsSpelledOut) {
  Diagnostic d = example();
  d.message = "there is no file '\x1b[2Jx'";
  d.file = "a\nb\x1b.pov";
  d.source_line.clear();
  EXPECT_EQ(format(d), "a\\nb\\x1b.pov:4:1: error: there is no file '\\x1b[2Jx'");
}

TEST(Diagnostic, LongLinesAreCutAroundThePlace) {
  Diagnostic d = example();
  d.source_line = std::string(5000, ' ') + "box" + std::string(5000, '.');
  d.column = 5001;
  const std::string text = format(d);
  EXPECT_LT(text.size(), 500u);
  const std::size_t lines = text.find('\n');
  const std::string shown = text.substr(lines + 1, text.rfind('\n') - lines - 1);
  const std::string caret = text.substr(text.rfind('\n') + 1);
  EXPECT_EQ(shown.find("box"), caret.find('^'));
}

}  // namespace
}  // namespace firstlight::render
