#include "app/steer_connection.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace firstlight::app {
namespace {

// poll() promises that so much can be written to a pipe without waiting.
constexpr std::size_t kWrite = 512;

bool is_temporary(int error) { return error == EINTR || error == EAGAIN || error == EWOULDBLOCK; }

}  // namespace

void SteerConnection::read(SteerCommands& commands) {
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(in_, buffer.data(), buffer.size());
  if (count > 0) return take({buffer.data(), static_cast<std::size_t>(count)}, commands);
  if (count < 0 && is_temporary(errno)) return;
  // A last line need not be ended, as with `printf status | firstlight ... --steer -`.
  if (count == 0) answer(line_, commands);
  line_.clear();
  ended_ = true;
}

void SteerConnection::take(std::string_view text, SteerCommands& commands) {
  while (!text.empty() && !ended_) {
    const std::size_t end = text.find('\n');
    line_ += text.substr(0, end);
    if (line_.size() > kLongestLine) {
      answers_ += fmt::format("error a line has {} characters at most\n", kLongestLine);
      ended_ = true;
      return;
    }
    if (end == std::string_view::npos) return;
    answer(line_, commands);
    line_.clear();
    text.remove_prefix(end + 1);
  }
}

void SteerConnection::answer(std::string_view line, SteerCommands& commands) {
  const SteerCommands::Answer answer = commands.answer(line);
  if (!answer.text.empty()) answers_ += answer.text + '\n';
  ended_ = ended_ || answer.goodbye;
}

void SteerConnection::write() {
  const ssize_t count = is_socket_ ? ::send(out_, answers_.data(), answers_.size(), MSG_NOSIGNAL)
                                   : ::write(out_, answers_.data(), std::min(answers_.size(), kWrite));
  if (count >= 0) {
    answers_.erase(0, static_cast<std::size_t>(count));
  } else if (!is_temporary(errno)) {
    broken_ = true;
  }
}

}  // namespace firstlight::app
