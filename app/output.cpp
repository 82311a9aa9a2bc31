#include "app/output.h"

#include "render/scene/escaped.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <system_error>

namespace firstlight::app {
namespace {

constexpr int kForEver = -1;
/// After a signal nobody waits long for a reader who does not read.
constexpr int kLastWaitMilliseconds = 100;

bool is_writable(int descriptor, int wait_milliseconds) {
  pollfd waiting{descriptor, POLLOUT, 0};
  return ::poll(&waiting, 1, wait_milliseconds) > 0;
}

/// Returns 0, or the error.
int write_all(int descriptor, std::string_view text) noexcept {
  int wait = kForEver;
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
      continue;
    }
    const int error = errno;
    if (error == EINTR) wait = kLastWaitMilliseconds;
    if (error != EINTR && error != EAGAIN && error != EWOULDBLOCK) return error;
    if (!is_writable(descriptor, wait)) {
      if (wait != kForEver) return error;
      wait = kLastWaitMilliseconds;  // a signal came while it waited
    }
  }
  return 0;
}

/// Calls `make` for the text to be written. To be out of memory costs a message, no more.
template <class Make>
void tell(const Make& make) noexcept {
  try {
    write_all(STDERR_FILENO, make());
  } catch (const std::exception&) {
    constexpr std::string_view kLost = "firstlight: not enough memory for a message\n";
    write_all(STDERR_FILENO, kLost);
  }
}

}  // namespace

void secure_standard_streams() {
  // So opened that their use fails as it would if they were closed. The lowest free number is what open() takes.
  constexpr std::array kModes = {O_WRONLY, O_RDONLY, O_RDONLY};
  for (int descriptor = 0; descriptor <= STDERR_FILENO; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      ::open("/dev/null", kModes[static_cast<std::size_t>(descriptor)]);
  }
  ::signal(SIGPIPE, SIG_IGN);
}

void say(std::string_view text) noexcept {
  tell([&] { return render::escaped_lines(text) + '\n'; });
}

void say_error(std::string_view why) noexcept {
  tell([&] { return fmt::format("firstlight: error: {}\n", render::escaped(why)); });
}

void say_error_in_lines(std::string_view why) noexcept {
  tell([&] { return fmt::format("firstlight: error: {}\n", render::escaped_lines(why)); });
}

void say_warning(std::string_view what) noexcept {
  tell([&] { return fmt::format("firstlight: warning: {}\n", render::escaped(what)); });
}

void say_piece(std::string_view text) noexcept {
  tell([&] { return render::escaped_lines(text); });
}

void draw(std::string_view text) noexcept {
  if (is_writable(STDERR_FILENO, 0)) write_all(STDERR_FILENO, text);
}

std::string print_result(std::string_view text) {
  const int error = write_all(STDOUT_FILENO, text);
  return error == 0 ? "" : "cannot write to the standard output: " + std::generic_category().message(error);
}

}  // namespace firstlight::app
