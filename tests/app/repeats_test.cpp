#include "app/repeats.h"

#include <gtest/gtest.h>

namespace firstlight::app {
namespace {

using render::Diagnostic;

Diagnostic warning(const std::string& message, std::size_t line) {
  Diagnostic result;
  result.severity = Diagnostic::Severity::warning;
  result.file = "scene.pov";
  result.line = line;
  result.column = 3;
  result.message = message;
  result.source_line = "text";
  return result;
}

TEST(Repeats, AWarningIsShownOnceAndCounted) {
  Repeats repeats;
  int shown = 0;
  for (int i = 0; i < 257; ++i) shown += repeats.is_new(warning("division by zero", 4)) ? 1 : 0;
  EXPECT_EQ(shown, 1);
  EXPECT_TRUE(repeats.is_new(warning("another", 9)));
  ASSERT_EQ(repeats.counts().size(), 1u);
  EXPECT_EQ(render::format(repeats.counts()[0]), "scene.pov:4:3: note: this warning came 257 times");
}

TEST(Repeats, OfManyPlacesTheFirstAreShown) {
  Repeats repeats;
  std::size_t shown = 0;
  for (std::size_t line = 1; line <= 257; ++line) shown += repeats.is_new(warning("division by zero", line)) ? 1 : 0;
  EXPECT_EQ(shown, Repeats::kMostPlaces);
  ASSERT_EQ(repeats.counts().size(), 1u);
  EXPECT_EQ(render::format(repeats.counts()[0]),
            "scene.pov:1:3: note: this warning came 257 times, here and at other places");
}

TEST(Repeats, ErrorsAndWhatTheSceneSaysAreShownEachTime) {
  Repeats repeats;
  for (const auto severity : {Diagnostic::Severity::error, Diagnostic::Severity::debug, Diagnostic::Severity::note}) {
    Diagnostic diagnostic = warning("again", 1);
    diagnostic.severity = severity;
    EXPECT_TRUE(repeats.is_new(diagnostic) && repeats.is_new(diagnostic));
  }
  EXPECT_TRUE(repeats.counts().empty());
}

}  // namespace
}  // namespace firstlight::app
