#include "tests/golden/render.h"

namespace firstlight::golden {

ProcessResult render(const std::string& program, const std::filesystem::path& scene,
                     const std::filesystem::path& picture, const std::filesystem::path& home,
                     const std::vector<std::string>& more) {
  std::vector<std::string> command{
      program, "+I" + scene.filename().string(), "+O" + picture.string(), "+W160", "+H120", "+WT1", "-J", "-A", "-D",
      "+FN"};
  command.insert(command.end(), more.begin(), more.end());
  return run_process(command, scene.parent_path(), home, kRenderLimit);
}

}  // namespace firstlight::golden
