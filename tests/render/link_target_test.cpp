#include "render/image/link_target.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

namespace firstlight::render {
namespace {

namespace fs = std::filesystem;

TEST(LinkTarget, FollowsLinksToWhatNeedNotExist) {
  const fs::path folder = fs::temp_directory_path() / ("firstlight-links-" + std::to_string(getpid()));
  fs::create_directories(folder / "deep");
  fs::create_symlink("b", folder / "a");
  fs::create_symlink("deep/c", folder / "b");
  fs::create_symlink(folder / "end", folder / "deep" / "c");
  fs::create_symlink("circle", folder / "circle");
  EXPECT_EQ(link_target(folder / "plain"), folder / "plain");
  EXPECT_EQ(link_target(folder / "b"), folder / "end");
  EXPECT_EQ(link_target(folder / "a"), folder / "end");
  EXPECT_EQ(link_target(folder / "circle"), folder / "circle");
  EXPECT_EQ(link_target("no_folder/x"), "no_folder/x");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace firstlight::render
