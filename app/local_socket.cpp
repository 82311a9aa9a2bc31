#include "app/local_socket.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>

namespace firstlight::app {
namespace {

constexpr int kWaitingConnections = 16;
constexpr mode_t kOwnerOnly = 0600;

std::string reason() { return std::strerror(errno); }

/// False when the path is too long for an address.
bool make_address(const std::string& path, sockaddr_un& address, std::string& error) {
  address = {};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) {
    error = fmt::format("socket '{}': a socket's path has 1 to {} characters", path, sizeof address.sun_path - 1);
    return false;
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return true;
}

int connect_socket(int socket, const sockaddr_un& address) {
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

/// Removes the socket that a program which is no more has left. False when something else is there.
bool make_room(const std::string& path, const sockaddr_un& address, std::string& error) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return true;
  if (!S_ISSOCK(status.st_mode)) {
    error = fmt::format("socket '{}': there is a file of that name", path);
    return false;
  }
  const Descriptor probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (connect_socket(probe.get(), address) == 0 || errno != ECONNREFUSED) {
    error = fmt::format("socket '{}': another program listens there", path);
    return false;
  }
  if (::unlink(path.c_str()) != 0) {
    error = fmt::format("socket '{}': the old one cannot be removed: {}", path, reason());
    return false;
  }
  return true;
}

}  // namespace

std::optional<LocalListener> LocalListener::open(const std::string& path, std::string& error) {
  sockaddr_un address;
  if (!make_address(path, address, error) || !make_room(path, address, error)) return std::nullopt;
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  // The mode before bind() is the mode of the file from its first moment.
  if (!socket || ::fchmod(socket.get(), kOwnerOnly) != 0 ||
      ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    error = fmt::format("socket '{}': {}", path, reason());
    return std::nullopt;
  }
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || ::listen(socket.get(), kWaitingConnections) != 0) {
    error = fmt::format("socket '{}': {}", path, reason());
    ::unlink(path.c_str());
    return std::nullopt;
  }
  return LocalListener(std::move(socket), path, status.st_dev, status.st_ino);
}

LocalListener::~LocalListener() {
  if (!socket_) return;
  struct stat status {};
  const bool is_ours = ::lstat(path_.c_str(), &status) == 0 && status.st_dev == device_ && status.st_ino == inode_;
  if (is_ours) ::unlink(path_.c_str());
}

Descriptor LocalListener::accept() const {
  return Descriptor(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
}

Descriptor connect_to(const std::string& path, std::string& error) {
  sockaddr_un address;
  if (!make_address(path, address, error)) return {};
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket || connect_socket(socket.get(), address) != 0) {
    const bool nobody = errno == ECONNREFUSED || errno == ENOENT;
    error = nobody ? fmt::format("socket '{}': nobody listens there", path)
                   : fmt::format("socket '{}': {}", path, reason());
    return {};
  }
  return socket;
}

}  // namespace firstlight::app
