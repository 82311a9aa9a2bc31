#include "app/terminal_keys.h"

#include "app/thread_signals.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <string_view>

namespace firstlight::app {
namespace {

// So long the terminal may be another's after the program has come back to the foreground.
constexpr int kRefreshMilliseconds = 250;

}  // namespace

void TerminalKeys::start(priority::Steering& steering, Desk& desk) {
  line_.set_hint("? for keys");
  terminal_.emplace();
  thread_ = std::thread([this, commands = KeyCommands(steering, desk)] { run(commands); });
}

TerminalKeys::~TerminalKeys() {
  if (!thread_.joinable()) return;
  end_.ring();
  thread_.join();
}

void TerminalKeys::run(KeyCommands commands) {
  block_signals();
  std::array<pollfd, 2> waiting{{{end_.readable(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
  while (true) {
    const int ready = ::poll(waiting.data(), waiting.size(), kRefreshMilliseconds);
    if (ready > 0 && waiting[0].revents != 0) return;
    terminal_->refresh();
    if (ready <= 0 || waiting[1].revents == 0) continue;
    std::array<char, 64> buffer;
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count <= 0) {
      // In the background nothing can be read though something is there; a terminal that is gone stays so.
      ::poll(waiting.data(), 1, kRefreshMilliseconds);
      continue;
    }
    for (const char key : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
      if (const std::string text = commands.press(key); !text.empty()) line_.note(text);
    }
  }
}

}  // namespace firstlight::app
