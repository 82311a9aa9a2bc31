#include "tests/golden/terminal.h"

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace firstlight::golden {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWait = 20;  // milliseconds
constexpr std::size_t kMostText = 4096;

}  // namespace

Terminal::Terminal(const std::vector<std::string>& command, const std::filesystem::path& folder) {
  winsize size{};
  size.ws_col = 160;
  size.ws_row = 40;
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("forkpty failed");
  if (child_ > 0) return;
  unsetenv("DISPLAY");
  if (chdir(folder.c_str()) != 0) _exit(127);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

Terminal::~Terminal() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  if (terminal_ >= 0) close(terminal_);
}

void Terminal::type(const std::string& keys) const {
  if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("cannot type");
  }
}

void Terminal::signal(int number) const { kill(child_, number); }

void Terminal::go_away() { close(std::exchange(terminal_, -1)); }

void Terminal::read() {
  pollfd waiting{terminal_, POLLIN, 0};
  if (poll(&waiting, 1, kWait) <= 0) return;
  std::array<char, 4096> buffer;
  const ssize_t count = ::read(terminal_, buffer.data(), buffer.size());
  if (count > 0) {
    text_.append(buffer.data(), static_cast<std::size_t>(count));
    if (text_.size() > kMostText) text_.erase(0, text_.size() - kMostText);
  } else {
    usleep(1000 * kWait);  // nobody has the terminal open any more: poll() no longer waits
  }
}

bool Terminal::wait_for(const std::string& text, std::chrono::seconds limit) {
  for (const auto end = Clock::now() + limit; Clock::now() < end;) {
    if (const std::size_t at = text_.find(text); at != std::string::npos) {
      text_.erase(0, at + text.size());
      return true;
    }
    read();
  }
  return false;
}

int Terminal::wait_for_end(std::chrono::seconds limit) {
  for (const auto end = Clock::now() + limit; Clock::now() < end;) {
    int status = 0;
    read();
    if (waitpid(child_, &status, WNOHANG) != child_) continue;
    child_ = -1;
    read();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  return -1;
}

bool Terminal::is_ordinary() const {
  termios mode{};
  return tcgetattr(terminal_, &mode) == 0 && (mode.c_lflag & ICANON) != 0 && (mode.c_lflag & ECHO) != 0;
}

}  // namespace firstlight::golden
