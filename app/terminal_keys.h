#pragma once

#include "app/control.h"
#include "app/key_commands.h"
#include "app/progress.h"
#include "app/raw_terminal.h"
#include "app/wake_up.h"

#include <optional>
#include <thread>

namespace firstlight::app {

/// Lets the one at the terminal steer a picture with single keys.
/// Threads  One of its own.
class TerminalKeys final : public Control {
 public:
  /// Answers to keys are told on `line`.
  explicit TerminalKeys(ProgressLine& line) : line_(line) {}
  ~TerminalKeys() override;

  void start(priority::Steering& steering, Desk& desk) override;

 private:
  void run(KeyCommands commands);

  ProgressLine& line_;
  std::optional<RawTerminal> terminal_;
  WakeUp end_;
  std::thread thread_;
};

}  // namespace firstlight::app
