// The report of `firstlight compare`, opened from the disk in a browser.

#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLimit{120};
constexpr const char* kRoom = "camera { location -5*z look_at 0 }\nlight_source { <3, 4, -5> rgb 1 }\n";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class CompareReport : public ::testing::Test {
 protected:
  CompareReport() {
    fs::create_directories(scratch_ / "scenes");
    // POV-Ray is told of Other, so that its picture is another one.
    scratch_.write("scenes/agrees.pov", std::string(kRoom) + "sphere { 0, 1 pigment { rgb 1 } }");
    scratch_.write("scenes/differs.pov", std::string(kRoom) +
                                             "sphere { 0, 1 pigment { rgb 1 } }\n#ifdef (Other) box { <-3, -3, 2>, 3 "
                                             "pigment { rgb <1, 0, 0> } } #end");
    scratch_.write("scenes/lacks.pov", std::string(kRoom) + "media { emission 0.1 }");
    const fs::path povray = scratch_.write("povray", "#!/bin/sh\nexec povray \"$@\" Declare=Other=1\n");
    fs::permissions(povray, fs::perms::owner_all);
  }

  /// The page as it is when its script has run, with `more` run behind it.
  std::string opened(const std::string& page, const std::string& more = "") {
    const fs::path file = scratch_ / ("report/" + page);
    if (!more.empty()) {
      std::string html = text_of(file);
      const std::size_t end = html.rfind("</body>");
      EXPECT_NE(end, std::string::npos) << page;
      std::ofstream(file) << html.insert(end, "<script>" + more + "</script>");
    }
    return browse("file://" + file.string()).out;
  }

  ProcessResult browse(const std::string& address) {
    return run_process({"chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                        "--disable-background-networking", "--disable-component-update", "--disable-sync",
                        "--user-data-dir=" + (scratch_ / "profile").string(), "--window-size=1280,1000",
                        "--virtual-time-budget=5000", "--dump-dom", address},
                       scratch_.path(), scratch_.path(), kLimit);
  }

  ScratchFolder scratch_;
};

void expect_ran(const std::string& dom) {
  EXPECT_NE(dom.find("data-ready=\"yes\""), std::string::npos) << dom.substr(0, 500);
  EXPECT_EQ(dom.find("data-error"), std::string::npos) << dom.substr(0, 500);
}

TEST_F(CompareReport, WorksInABrowser) {
  const ProcessResult start = browse("data:text/html,<p>here</p>");
  if (start.out.find("<p>here</p>") == std::string::npos) {
    GTEST_SKIP() << "Chromium (Debian package chromium) cannot start here: " << start.summary() << '\n'
                 << start.err.substr(0, 1000);
  }
  const ProcessResult made = run_process(
      {program_under_test(), "compare", "scenes", "--size", "64x48", "--povray", "./povray", "--report", "report"},
      scratch_.path(), scratch_.path(), kLimit);
  ASSERT_EQ(made.exit_code, 4) << made.summary() << '\n' << made.err;

  // Worst first; then the name is chosen, a feature is looked for, and what differs is hidden.
  const std::string index = opened("index.html");
  expect_ran(index);
  const std::size_t differs = index.find("data-name=\"differs\"");
  const std::size_t agrees = index.find("data-name=\"agrees\"");
  const std::size_t lacks = index.find("data-name=\"lacks\"");
  EXPECT_TRUE(differs < agrees && agrees < lacks && lacks != std::string::npos)
      << differs << ' ' << agrees << ' ' << lacks;
  EXPECT_NE(index.find("<output>3 of 3</output>"), std::string::npos);
  EXPECT_NE(index.find("aria-sort=\"ascending\""), std::string::npos);

  const std::string chosen = opened("index.html",
                                    "document.querySelector('th[data-sort=name] button').click();"
                                    "document.querySelector('th[data-sort=name] button').click();"
                                    "document.querySelector('.chip[value=differs]').click();");
  expect_ran(chosen);
  EXPECT_GT(chosen.find("data-name=\"agrees\""), chosen.find("data-name=\"lacks\"")) << "by name, backwards";
  EXPECT_NE(chosen.find("<output>2 of 3</output>"), std::string::npos);

  const std::string scene = opened("scenes/0002-differs.html");
  expect_ran(scene);
  EXPECT_NE(scene.find("--wipe: 50%"), std::string::npos);
  EXPECT_EQ(scene.find("pixel (5, 7)"), std::string::npos);
  EXPECT_NE(scene.find("class=\"swatch\""), std::string::npos) << "the worst pixels have their colours";

  // The wipe is dragged to a quarter and moved on by a key; a click on a pixel shows it.
  const std::string used = opened(
      "scenes/0002-differs.html",
      "const box = frame.getBoundingClientRect(), handle = document.querySelector('.handle');"
      "handle.setPointerCapture = () => {}; handle.hasPointerCapture = () => true;"
      "handle.dispatchEvent(new PointerEvent('pointerdown', { pointerId: 1 }));"
      "handle.dispatchEvent(new PointerEvent('pointermove', { pointerId: 1, clientX: box.left + box.width / 4 }));"
      "handle.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight' }));"
      "frame.dispatchEvent(new MouseEvent('click', { clientX: box.left + 5.5 * box.width / 64,"
      "  clientY: box.top + 7.5 * box.height / 48 }));"
      "document.querySelector('.views button[value=flip]').click();");
  expect_ran(used);
  EXPECT_NE(used.find("--wipe: 27%"), std::string::npos);
  EXPECT_NE(used.find("aria-valuenow=\"27\""), std::string::npos);
  EXPECT_NE(used.find("pixel (5, 7)"), std::string::npos);
  EXPECT_NE(used.find("data-view=\"flip\""), std::string::npos);

  const std::string lacking = opened("scenes/0003-lacks.html");
  expect_ran(lacking);
  EXPECT_NE(lacking.find("lacks.pov:3:1"), std::string::npos) << "what is missing, with its place";
}

}  // namespace
}  // namespace firstlight::golden
