#include "tests/golden/run.h"

#include <fstream>

namespace firstlight::golden {

ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::filesystem::path& home, std::chrono::seconds limit) {
  return app::compare::run_process({command, folder, limit, home, nullptr});
}

std::filesystem::path ScratchFolder::write(const std::string& name, const std::string& content) const {
  const std::filesystem::path file = path() / name;
  std::ofstream(file, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
  return file;
}

}  // namespace firstlight::golden
