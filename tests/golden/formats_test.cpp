// Which formats need OpenImageIO's module: none of those that are at hand opens it.

#include "tests/golden/render.h"
#include "tests/golden/run.h"

#include <gtest/gtest.h>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

const char* const kScene = "camera { location -5*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }";

TEST(Formats, TheCommonOnesNeedNoModule) {
  const ScratchFolder scratch;
  // A program that finds no module beside it.
  const fs::path program = scratch / "program" / "of" / "its" / "own";
  fs::create_directories(program.parent_path());
  fs::copy_file(program_under_test(), program);
  scratch.write("scene.pov", kScene);
  const auto render = [&](const char* format) {
    return run_process({program.string(), "scene.pov", "+W16", "+H12", "-D", format}, scratch.path(), scratch.path(),
                       kRenderLimit);
  };
  for (const char* format : {"+FN", "+FJ", "+FP", "+FT", "+FC", "+FB"}) {
    const ProcessResult result = render(format);
    EXPECT_TRUE(result.succeeded()) << format << ' ' << result.summary() << '\n' << result.err;
  }
  const ProcessResult without = render("+FE");
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.err.find("the module for picture files cannot be opened"), std::string::npos) << without.err;
  for (const char* name : {"scene.png", "scene.jpg", "scene.ppm", "scene.tga", "scene.bmp"})
    EXPECT_TRUE(fs::exists(scratch / name));
  EXPECT_FALSE(fs::exists(scratch / "scene.exr"));
}

}  // namespace
}  // namespace firstlight::golden
