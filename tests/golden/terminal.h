#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {

/// A program that runs on a terminal of its own, with somebody who reads and types.
class Terminal {
 public:
  /// Runs `command` in `folder`; throws std::runtime_error when that cannot be.
  Terminal(const std::vector<std::string>& command, const std::filesystem::path& folder);
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  /// Kills the program if it still runs.
  ~Terminal();

  void type(const std::string& keys) const;
  /// Sends a signal to the program, as another program would.
  void signal(int number) const;
  /// Takes the terminal away from under the program; nothing can be read or typed any more.
  void go_away();
  /// Reads until the program has written `text`; false when it has not within `limit`.
  bool wait_for(const std::string& text, std::chrono::seconds limit);
  /// Waits for the program's end: its exit code, -1 when a signal ended it or the limit did.
  int wait_for_end(std::chrono::seconds limit);

  /// The end of what the program has written since the last wait_for() that was answered.
  const std::string& text() const { return text_; }
  /// Whether the terminal shows what is typed and hands it over by lines, as a shell left it.
  bool is_ordinary() const;

 private:
  /// Takes what the program has written, and waits a little for it.
  void read();

  pid_t child_ = -1;
  int terminal_ = -1;
  std::string text_;
};

}  // namespace firstlight::golden
