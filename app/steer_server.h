#pragma once

#include "app/control.h"
#include "app/local_socket.h"
#include "app/steer_commands.h"
#include "app/steer_connection.h"
#include "app/wake_up.h"

#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace firstlight::app {

/// Lets programs and people steer a picture over a local socket, several at once, or over the standard input.
///
/// Threads  One of its own between start() and the end.
class SteerServer final : public Control {
 public:
  /// `address`: the path of the socket to make, or "-" for the standard input and output. On failure the result is null
  /// and `error` says why. Who connects before start() waits.
  static std::unique_ptr<SteerServer> open(const std::string& address, std::string& error);
  /// Answers what has been asked, as far as that goes without waiting, and ends.
  ~SteerServer() override;

  void start(priority::Steering& steering, Desk& desk) override;

 private:
  explicit SteerServer(std::optional<LocalListener> listener) : listener_(std::move(listener)) {}
  void run(SteerCommands commands);
  void admit();

  std::optional<LocalListener> listener_;  ///< empty: the standard input
  WakeUp end_;
  std::vector<SteerConnection> connections_;
  std::thread thread_;
};

}  // namespace firstlight::app
