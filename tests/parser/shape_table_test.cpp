#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace firstlight::parser {
namespace {

namespace fs = std::filesystem;

/// Every shape that is rendered, as the scene language has it.
constexpr const char* kWords[] = {
#define SHAPE(word, function) #word,
#define PATCH SHAPE
#define RICH SHAPE
#define FORM(word, function)
#include "parser/shapes.def"
#undef FORM
#undef RICH
#undef PATCH
#undef SHAPE
};

TEST(ShapeTable, EveryShapeThatIsRenderedHasItsScene) {
  for (const char* word : kWords) {
    EXPECT_TRUE(fs::exists(fs::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes" / "shapes" / (std::string(word) + ".pov")))
        << word;
  }
}

}  // namespace
}  // namespace firstlight::parser
