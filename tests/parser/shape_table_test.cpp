#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace firstlight::parser {
namespace {

namespace fs = std::filesystem;

/// Every shape of the scene language.
constexpr const char* kWords[] = {
#define SHAPE(word, function) #word,
#define PATCH SHAPE
#define RICH SHAPE
#include "parser/shapes.def"
#undef RICH
#undef PATCH
#undef SHAPE
};

TEST(ShapeTable, EveryShapeHasItsScene) {
  for (const char* word : kWords) {
    EXPECT_TRUE(fs::exists(fs::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes" / "shapes" / (std::string(word) + ".pov")))
        << word;
  }
}

}  // namespace
}  // namespace firstlight::parser
