#include "tests/golden/refusal.h"

#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <sstream>

namespace firstlight::golden {
namespace {

constexpr std::chrono::seconds kLimit{30};

void check_refused(const ProcessResult& result, const std::filesystem::path& picture) {
  EXPECT_EQ(result.exit_code, 1) << result.summary() << '\n' << result.err.substr(0, 3000);
  EXPECT_NE(result.err.find("error: "), std::string::npos) << "standard error: " << result.err.substr(0, 3000);
  EXPECT_FALSE(std::filesystem::exists(picture)) << "a refused scene left a picture";
}

}  // namespace

ProcessResult expect_refusal(const std::filesystem::path& scene, const ScratchFolder& scratch,
                             const std::vector<std::string>& more) {
  const auto picture = scratch / "refused.png";
  std::vector<std::string> options{"+I" + scene.string(), "+O" + picture.string(), "+W32", "+H24", "-D", "-V"};
  options.insert(options.end(), more.begin(), more.end());
  return expect_command_refused(options, picture, scratch);
}

ProcessResult expect_command_refused(const std::vector<std::string>& options, const std::filesystem::path& picture,
                                     const ScratchFolder& scratch) {
  std::vector<std::string> command{program_under_test()};
  command.insert(command.end(), options.begin(), options.end());
  const ProcessResult result = run_process(command, scratch.path(), scratch.path(), kLimit);
  check_refused(result, picture);
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace firstlight::golden
