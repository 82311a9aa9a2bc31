#include "app/key_commands.h"

#include "priority/schemes.h"
#include "tests/app/steered.h"

#include <gtest/gtest.h>

#include <string_view>

namespace firstlight::app {
namespace {

TEST(KeyCommands, SpacePausesAndContinues) {
  Steered steered;
  KeyCommands keys(steered.steering, steered.desk);
  EXPECT_NE(keys.press(' '), "");
  EXPECT_TRUE(steered.steering.paused());
  EXPECT_NE(keys.press(' '), "");
  EXPECT_FALSE(steered.steering.paused());
}

TEST(KeyCommands, DigitsAndLettersChooseSchemes) {
  Steered steered;
  KeyCommands keys(steered.steering, steered.desk);
  char key = '1';
  for (const priority::SchemeRow& scheme : priority::schemes()) {
    if (scheme.make == nullptr) continue;  // not while it renders
    EXPECT_EQ(keys.press(key), "scheme " + std::string(scheme.example));
    EXPECT_EQ(steered.steering.order().text(), scheme.example);
    if (++key > '9') break;
  }
  keys.press('l');
  EXPECT_EQ(steered.steering.order().text(), "level");
  keys.press('c');
  EXPECT_EQ(steered.steering.order().text(), "contribution");
}

TEST(KeyCommands, StopSaveAndDrop) {
  Steered steered;
  KeyCommands keys(steered.steering, steered.desk);
  steered.answer("boost light 0");
  keys.press('d');
  EXPECT_TRUE(steered.steering.order().boosts().empty());
  while_served(
      steered, [](const std::string&) { return "no room"; }, [&] { EXPECT_EQ(keys.press('s'), "not saved: no room"); });
  keys.press('q');
  EXPECT_TRUE(steered.steering.stopped());
}

TEST(KeyCommands, OthersMeanNothing) {
  Steered steered;
  KeyCommands keys(steered.steering, steered.desk);
  const auto version = steered.steering.version();
  for (const char key : {'\0', '\n', '\r', '\t', '0', 'Z', '~', '\x7f', '\xff'}) EXPECT_EQ(keys.press(key), "");
  EXPECT_EQ(steered.steering.version(), version);
  EXPECT_FALSE(steered.steering.paused());
}

TEST(KeyCommands, ArrowsAndTheLikeAreNotTheirLetters) {
  Steered steered;
  KeyCommands keys(steered.steering, steered.desk);
  // Up, F1, Delete, Ctrl-Right, Alt-q.
  for (const char key : std::string_view("\x1b[A\x1bOP\x1b[3~\x1b[1;5C\x1bq")) EXPECT_EQ(keys.press(key), "");
  EXPECT_EQ(steered.steering.order().text(), "contribution");
  EXPECT_FALSE(steered.steering.stopped());
  EXPECT_NE(keys.press(' '), "");
}

TEST(KeyCommands, HelpShowsThemAll) {
  Steered steered;
  const std::string help = KeyCommands(steered.steering, steered.desk).press('?');
  for (const char* word : {"space", "pause", "q", "save", "1", "contribution", "level"}) {
    EXPECT_NE(help.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace firstlight::app
