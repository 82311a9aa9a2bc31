#include "app/steer_client.h"

#include "app/exit_code.h"
#include "app/local_socket.h"
#include "app/output.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <iostream>
#include <optional>
#include <string_view>

namespace firstlight::app {
namespace {

/// The other end of a SteerServer's socket.
class Line {
 public:
  explicit Line(Descriptor socket) : socket_(std::move(socket)) {}

  bool send(std::string text) {
    text += '\n';
    std::string_view rest = text;
    while (!rest.empty()) {
      const ssize_t count = ::send(socket_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
  }

  /// The next line, without its end; nothing when the other end has gone.
  std::optional<std::string> receive() {
    while (received_.find('\n') == std::string::npos) {
      std::array<char, 4096> buffer;
      const ssize_t count = ::recv(socket_.get(), buffer.data(), buffer.size(), 0);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return std::nullopt;
      received_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    std::string line = received_.substr(0, received_.find('\n'));
    received_.erase(0, line.size() + 1);
    return line;
  }

 private:
  Descriptor socket_;
  std::string received_;
};

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n\f\v") == std::string_view::npos; }

/// One command and its answer. Returns false when the other end has gone.
bool ask(Line& line, const std::string& command, bool& refused) {
  if (is_blank(command)) return true;
  const bool sent = line.send(command);
  const std::optional<std::string> answer = sent ? line.receive() : std::nullopt;
  if (!answer) return false;
  const std::string problem = print_result(*answer + '\n');
  if (!problem.empty()) say_error(problem);
  refused = refused || !problem.empty() || !answer->starts_with("ok");
  return true;
}

}  // namespace

int steer_client(std::span<const std::string> arguments) {
  if (arguments.empty()) return fail("no socket given; usage: firstlight steer SOCKET [command]");
  std::string problem;
  Descriptor socket = connect_to(arguments[0], problem);
  if (!socket) return fail(problem);
  Line line(std::move(socket));
  bool refused = false;
  if (arguments.size() > 1) {
    const std::string command = fmt::format("{}", fmt::join(arguments.subspan(1), " "));
    if (!ask(line, command, refused)) return fail("the rendering has ended");
    return refused ? kExitFailure : 0;
  }
  for (std::string command; std::getline(std::cin, command);) {
    if (!ask(line, command, refused)) return fail("the rendering has ended");
    if (command == "quit") break;
  }
  return refused ? kExitFailure : 0;
}

}  // namespace firstlight::app
