#pragma once
#include "app/compare/process.h"
#include "app/compare/scratch_folder.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {

using app::compare::ProcessResult;

/// Runs `command` in `folder`, with `home` as its HOME, and waits at most `limit`.
ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::filesystem::path& home, std::chrono::seconds limit);

class ScratchFolder : public app::compare::ScratchFolder {
 public:
  ScratchFolder() {}  // NOLINT(modernize-use-equals-default): or there could be no constant one

  /// Writes a file into the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;
};

}  // namespace firstlight::golden
