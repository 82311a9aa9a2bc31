#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {

/// How a program that was run to its end came out.
struct ProcessResult {
  int exit_code = -1;      ///< what it returned; -1 when a signal ended it
  int signal = 0;          ///< the signal that ended it, 0 for none
  bool timed_out = false;  ///< it was stopped at the time limit
  double seconds = 0;
  long peak_kilobytes = 0;  ///< of memory, of the program itself
  std::string out;          ///< standard output
  std::string err;          ///< standard error

  bool succeeded() const { return exit_code == 0; }
  /// One line for a test's message: "exit code 1 after 0.2 s", "signal 11 (Segmentation fault) after ...".
  std::string summary() const;
};

/// Runs `command` in `folder`, without a display and with `home` as its HOME, and waits at most `limit`.
/// The program and all it started are killed at the limit.
ProcessResult run_process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::filesystem::path& home, std::chrono::seconds limit);

/// A folder of its own under /tmp (which POV-Ray's own file restrictions allow), removed at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file into the folder and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace firstlight::golden
