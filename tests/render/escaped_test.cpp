#include "render/scene/escaped.h"

#include <gtest/gtest.h>

#include <string>

namespace firstlight::render {
namespace {

TEST(Escaped, ShowsWhatWouldSteerATerminal) {
  EXPECT_EQ(escaped("\x1b]0;evil\x07"), "\\x1b]0;evil\\x07");
  EXPECT_EQ(escaped("a\r\n\tb\x7f"), "a\\x0d\\n\\tb\\x7f");
  EXPECT_EQ(escaped(std::string("\0x", 2)), "\\x00x");
  EXPECT_EQ(escaped("\xc2\x9b"
                    "2J"),
            "\\xc2\\x9b2J")
      << "the same as ESC [ in one character";
}

TEST(Escaped, LeavesTextAsItIs) {
  for (const char* text : {"", "plain \\ text",
                           "gr\xc3\xbc\xc3\x9f"
                           "e",
                           "\xc2\xa0\xc2", "\xe2\x82\xac \xff"}) {
    EXPECT_EQ(escaped(text), text);
    EXPECT_EQ(escaped_lines(text), text);
  }
}

TEST(Escaped, LinesStayLines) {
  EXPECT_EQ(escaped_lines("a\n\tb\x1b\n"), "a\n\tb\\x1b\n");
  EXPECT_EQ(escaped_lines(escaped_lines("\x1b")), "\\x1b");
}

}  // namespace
}  // namespace firstlight::render
