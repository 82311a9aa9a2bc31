#pragma once

#include "app/desk.h"
#include "priority/steering.h"

#include <string>

namespace firstlight::app {

/// Commands of a terminal's keys to a picture in progress.
/// Threads  One.
class KeyCommands {
 public:
  KeyCommands(priority::Steering& steering, Desk& desk) : steering_(steering), desk_(desk) {}

  /// Returns what to tell the user; empty: nothing, as for a key that means nothing.
  std::string press(char key);

 private:
  /// Arrows and the like come as several characters, which mean something else alone.
  bool is_within_sequence(char key);

  enum class Sequence { none, begun, parameters };
  Sequence sequence_ = Sequence::none;
  priority::Steering& steering_;
  Desk& desk_;
};

/// The keys and what they do, a line each.
std::string keys_help();

}  // namespace firstlight::app
