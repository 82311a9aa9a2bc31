#pragma once

#include "app/key_commands.h"
#include "app/progress.h"
#include "app/raw_terminal.h"
#include "app/wake_up.h"

#include <thread>

namespace firstlight::app {

/// Lets the one at the terminal steer a picture with single keys.
/// Threads  One of its own.
class TerminalKeys {
 public:
  /// What the keys do is told on `line`.
  TerminalKeys(KeyCommands commands, ProgressLine& line);
  ~TerminalKeys();

 private:
  void run();

  KeyCommands commands_;
  ProgressLine& line_;
  RawTerminal terminal_;
  WakeUp end_;
  std::thread thread_;
};

}  // namespace firstlight::app
