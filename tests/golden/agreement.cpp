#include "tests/golden/agreement.h"

#include "tests/golden/picture.h"
#include "tests/golden/render.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

/// The end of what a program printed, where its error is.
std::string tail(const std::string& text) {
  constexpr std::size_t kLength = 3000;
  return text.size() <= kLength ? text : "..." + text.substr(text.size() - kLength);
}

/// Leaves both pictures, their difference and the numbers where a person can look at them.
fs::path keep(const std::string& name, const Picture& ours, const Picture& theirs, const std::string& numbers) {
  const fs::path folder = fs::path(FIRSTLIGHT_BINARY_DIR) / "golden-failures" / name;
  fs::create_directories(folder);
  write_picture(ours, folder / "firstlight.png");
  write_picture(theirs, folder / "povray.png");
  write_picture(difference_picture(ours, theirs), folder / "difference.png");
  std::ofstream(folder / "numbers.txt") << "Firstlight against POV-Ray: " << numbers << '\n';
  return folder;
}

}  // namespace

void expect_agreement(const GoldenScene& scene, const std::vector<std::string>& more) {
  fs::remove_all(fs::path(FIRSTLIGHT_BINARY_DIR) / "golden-failures" / scene.name);

  const ScratchFolder scratch;
  const ProcessResult reference = render("povray", scene.file, scratch / "povray.png", scratch.path(), more);
  ASSERT_TRUE(reference.succeeded()) << "POV-Ray: " << reference.summary() << '\n' << tail(reference.err);
  const ProcessResult ours = render(program_under_test(), scene.file, scratch / "firstlight.png", scratch.path(), more);
  ASSERT_TRUE(ours.succeeded()) << "Firstlight: " << ours.summary() << '\n' << tail(ours.err);

  std::string why;
  const auto povray_picture = read_picture(scratch / "povray.png", why);
  ASSERT_TRUE(povray_picture) << why;
  const auto our_picture = read_picture(scratch / "firstlight.png", why);
  ASSERT_TRUE(our_picture) << why;
  ASSERT_EQ(our_picture->width, povray_picture->width);
  ASSERT_EQ(our_picture->height, povray_picture->height);

  const Comparison found = compare(*our_picture, *povray_picture);
  const bool agrees = scene.psnr ? found.psnr >= *scene.psnr : 100 * found.share >= scene.share;
  std::cout << scene.name << ": " << found.summary() << '\n';
  if (!agrees) {
    const fs::path folder = keep(scene.name, *our_picture, *povray_picture, found.summary());
    FAIL() << "Firstlight against POV-Ray: " << found.summary() << "\nSee " << folder.string();
  }
}

}  // namespace firstlight::golden
