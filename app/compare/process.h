#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// A program to be run, and how.
struct Command {
  std::vector<std::string> words;           ///< the program, looked for in PATH when it has no slash, and its arguments
  std::filesystem::path folder;             ///< in which it runs
  std::chrono::milliseconds limit{0};       ///< then it is ended
  std::filesystem::path home;               ///< its HOME; empty: ours
  const std::atomic<bool>* stop = nullptr;  ///< it is ended when this becomes true
};

/// How a program that was run to its end came out.
struct ProcessResult {
  std::string error;        ///< why it could not be run at all; empty when it was
  int exit_code = -1;       ///< what it returned; -1 when a signal ended it
  int signal = 0;           ///< the signal that ended it, 0 for none
  bool timed_out = false;   ///< it was ended at the time limit
  bool stopped = false;     ///< it was ended because Command::stop became true
  double seconds = 0.0;     ///< from its start to its end
  double processor = 0.0;   ///< seconds of processors, for it and for the system's work for it
  long peak_kilobytes = 0;  ///< of memory, of the program itself
  std::string out;          ///< standard output; of more than kMostOutput bytes the begin and the end
  std::string err;          ///< standard error, likewise

  bool succeeded() const { return exit_code == 0; }
  /// "exit code 1 after 0.2 s", "signal 11 (Segmentation fault) after 3.0 s", "stopped at the time limit, after 9.0 s"
  std::string summary() const;
};

constexpr std::size_t kMostOutput = std::size_t{8} << 20;  ///< bytes of one stream

/// Runs a program to its end, without a display and with nothing to read. It has a process group of its own: when it
/// ends, or is ended, so does everything it started that is still in the group. It also ends when the thread that called
/// this does.
ProcessResult run_process(const Command& command);

/// Where a shell would find `program`; nothing when it is not there or cannot be executed.
std::optional<std::filesystem::path> find_program(const std::string& program);

}  // namespace firstlight::app::compare
