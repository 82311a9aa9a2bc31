#include "tests/golden/steering_client.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <thread>

namespace firstlight::golden {

SteeringClient::SteeringClient(const std::filesystem::path& socket, std::chrono::seconds limit) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  socket.string().copy(address.sun_path, sizeof address.sun_path - 1);
  const auto end = std::chrono::steady_clock::now() + limit;
  while (descriptor_ < 0 && std::chrono::steady_clock::now() < end) {
    const int candidate = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(candidate, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
      descriptor_ = candidate;
    } else {
      ::close(candidate);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
}

SteeringClient::~SteeringClient() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string SteeringClient::ask(const std::string& line) {
  const std::string text = line + '\n';
  if (::send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size())) return {};
  std::string answer;
  for (char c = '\0'; ::recv(descriptor_, &c, 1, 0) == 1;) {
    if (c == '\n') return answer;
    answer += c;
  }
  return {};
}

}  // namespace firstlight::golden
