#pragma once

#include "priority/observer.h"

#include <cstdint>
#include <mutex>
#include <string>

namespace firstlight::app {

/// "12.3 M", "4567"-like short form of a count.
std::string short_count(std::uint64_t count);
/// "3.42 s", "2:05 min".
std::string short_time(double seconds);
/// "at most 0.0123 off", or "about" when it is an estimate.
std::string remaining_text(double remaining, bool is_bound);

/// "refining 43 %, at most 0.0123 off, 1.2 M rays done, 300 k waiting, 2.1 M a second, 3.20 s".
std::string progress_text(const priority::Progress& progress, double percent, bool paused);
/// How far the picture is by what is known of its rays, 0 to 100.
double percent_done(const priority::Progress& progress);

/// One line on the terminal that says how far the picture is; nothing when the error stream is not a terminal.
/// Threads  Any.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();

  bool is_shown() const { return shown_; }
  /// A stage without a measure: "reading the scene".
  void stage(const std::string& what);
  /// Kept at the end of the line from now on: "? for keys".
  void set_hint(std::string hint);
  void progress(const priority::Progress& progress, bool paused);
  /// Writes lines that stay, above the progress line; nothing when that is not shown.
  void note(const std::string& text);
  /// Takes the line off the screen, so that other text can be written.
  void clear();

 private:
  void show(std::string text);
  void wipe();

  const bool shown_;
  std::mutex mutex_;
  bool on_screen_ = false;
  std::string hint_;
  double percent_ = 0.0;  // never goes back, though the number of rays is only known at the end
};

}  // namespace firstlight::app
