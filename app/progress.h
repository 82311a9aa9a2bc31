#pragma once

#include "priority/observer.h"

#include <cstdint>
#include <string>

namespace firstlight::app {

/// "12.3 M", "4,567"-like short form of a count.
std::string short_count(std::uint64_t count);
/// "3.42 s", "2:05 min".
std::string short_time(double seconds);

/// One line on the terminal that says how far the picture is; nothing when the error stream is not a terminal.
class ProgressLine final : public priority::Observer {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() override;

  /// A stage without a measure: "reading the scene".
  void stage(const std::string& what);
  void progress(const priority::Progress& progress) override;
  /// Takes the line off the screen, so that other text can be written.
  void clear();

 private:
  void show(std::string text);

  const bool shown_;
  bool on_screen_ = false;
  double percent_ = 0.0;  // never goes back, though the number of rays is only known at the end
};

}  // namespace firstlight::app
