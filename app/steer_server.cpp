#include "app/steer_server.h"

#include "app/thread_signals.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string_view>

namespace firstlight::app {
namespace {

constexpr std::size_t kMostConnections = 32;
constexpr int kRestMilliseconds = 50;

}  // namespace

std::unique_ptr<SteerServer> SteerServer::open(const std::string& address, std::string& error) {
  const bool is_socket = address != "-";
  std::optional<LocalListener> listener = is_socket ? LocalListener::open(address, error) : std::nullopt;
  if (is_socket && !listener) return nullptr;
  return std::unique_ptr<SteerServer>(new SteerServer(std::move(listener)));
}

SteerServer::~SteerServer() {
  if (!thread_.joinable()) return;
  end_.ring();
  thread_.join();
}

void SteerServer::start(priority::Steering& steering, Desk& desk) {
  if (!listener_) connections_.emplace_back(STDIN_FILENO, STDOUT_FILENO);
  thread_ = std::thread([this, commands = SteerCommands(steering, desk)] { run(commands); });
}

void SteerServer::run(SteerCommands commands) {
  block_signals();  // a reader who has gone shall be an error, not the end of the program
  std::vector<pollfd> waiting;
  for (bool ending = false; !ending;) {
    waiting.assign(1, {end_.readable(), POLLIN, 0});
    waiting.push_back({listener_ ? listener_->descriptor() : -1, POLLIN, 0});
    for (const SteerConnection& connection : connections_) {
      waiting.push_back({connection.wants_input() ? connection.in() : -1, POLLIN, 0});
      waiting.push_back({connection.wants_output() ? connection.out() : -1, POLLOUT, 0});
    }
    if (::poll(waiting.data(), waiting.size(), -1) < 0) continue;
    ending = waiting[0].revents != 0;
    for (std::size_t i = 0; i < connections_.size(); ++i) {
      if (waiting[2 + 2 * i].revents != 0) connections_[i].read(commands);
      if (waiting[3 + 2 * i].revents != 0) connections_[i].write();
    }
    std::erase_if(connections_, [](const SteerConnection& connection) { return connection.is_over(); });
    if (waiting[1].revents != 0) admit();
  }
  for (SteerConnection& connection : connections_) {
    if (connection.wants_output()) connection.write();
  }
  connections_.clear();
}

void SteerServer::admit() {
  Descriptor socket = listener_->accept();
  if (!socket) {
    // When the system has no descriptor left, the one who waits makes poll() return at once, again and again.
    ::poll(nullptr, 0, kRestMilliseconds);
    return;
  }
  if (connections_.size() < kMostConnections) {
    connections_.emplace_back(std::move(socket));
    return;
  }
  constexpr std::string_view kFull = "error too many steer this picture already\n";
  ::send(socket.get(), kFull.data(), kFull.size(), MSG_NOSIGNAL);
}

}  // namespace firstlight::app
