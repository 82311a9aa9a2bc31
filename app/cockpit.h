#pragma once

#include "app/desk.h"
#include "app/progress.h"
#include "app/steer_commands.h"
#include "app/steer_server.h"
#include "app/terminal_keys.h"
#include "priority/steering.h"

#include <memory>
#include <optional>
#include <utility>

namespace firstlight::app {

/// The ways in which a picture is steered while one of these lives: the socket or the standard input if there is a
/// server, and the keys of the terminal if there is one.
class Cockpit {
 public:
  /// `server` may be null. `line` tells what the keys do; without `keys` there are none.
  Cockpit(priority::Steering& steering, Desk& desk, ProgressLine& line, std::unique_ptr<SteerServer> server, bool keys)
      : desk_(desk), commands_(steering, desk), server_(std::move(server)) {
    if (server_ != nullptr) server_->start(commands_);
    if (keys) {
      keys_.emplace(KeyCommands(steering, desk), line);
      line.set_hint("? for keys");
    }
  }
  Cockpit(const Cockpit&) = delete;
  Cockpit& operator=(const Cockpit&) = delete;
  /// Nobody is left waiting for a picture: the threads could not end.
  ~Cockpit() { desk_.close(); }

 private:
  Desk& desk_;
  SteerCommands commands_;
  std::unique_ptr<SteerServer> server_;
  std::optional<TerminalKeys> keys_;
};

}  // namespace firstlight::app
