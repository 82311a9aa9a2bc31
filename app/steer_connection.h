#pragma once

#include "app/descriptor.h"
#include "app/steer_commands.h"

#include <string>
#include <string_view>

namespace firstlight::app {

/// One who steers: the lines that come in, and the answers that go out.
///
/// Memory   at most a line, and the answers to what one read() takes: who does not read them is not read further.
class SteerConnection {
 public:
  static constexpr std::size_t kLongestLine = 8192;

  /// A socket, owned; it must not wait.
  explicit SteerConnection(Descriptor socket) : socket_(std::move(socket)), in_(socket_.get()), out_(socket_.get()) {}
  /// Descriptors that are somebody else's and may wait, such as the standard ones.
  SteerConnection(int in, int out) : in_(in), out_(out), is_socket_(false) {}

  int in() const { return in_; }
  int out() const { return out_; }
  bool wants_input() const { return !ended_ && answers_.empty(); }
  bool wants_output() const { return !answers_.empty(); }
  /// Nothing is left to do with it.
  bool is_over() const { return broken_ || (ended_ && answers_.empty()); }

  /// To be called when in() can be read: takes what is there, and answers as many lines as it ends.
  void read(SteerCommands& commands);
  /// To be called when out() can be written.
  void write();

 private:
  void take(std::string_view text, SteerCommands& commands);
  void answer(std::string_view line, SteerCommands& commands);

  Descriptor socket_;
  int in_;
  int out_;
  bool is_socket_ = true;
  std::string line_;     // received, without its end as yet
  std::string answers_;  // not sent as yet
  bool ended_ = false;   // nothing more will be read
  bool broken_ = false;  // nothing more can be written
};

}  // namespace firstlight::app
