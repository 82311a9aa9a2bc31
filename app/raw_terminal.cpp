#include "app/raw_terminal.h"

#include <signal.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>

namespace firstlight::app {
namespace {

// Handlers of signals can reach nothing else than globals.
termios g_former;  // the mode to come back to, valid while g_is_raw
std::atomic<bool> g_is_raw = false;
std::atomic<bool> g_is_leaving = false;  // a signal is about to end or stop the program
static_assert(std::atomic<bool>::is_always_lock_free, "handlers of signals read it");

constexpr std::array kDeadly = {SIGQUIT, SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL};

bool in_foreground() { return tcgetpgrp(STDIN_FILENO) == getpgrp(); }

void enter() {
  termios mode{};
  if (g_is_leaving || !in_foreground() || tcgetattr(STDIN_FILENO, &mode) != 0) return;
  if ((mode.c_lflag & (ICANON | ECHO)) == 0) return;
  g_is_raw = false;
  g_former = mode;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  g_is_raw = true;
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

// Installed with SA_RESETHAND: the same signal then does what it always does.
void restore_and_die(int signal) {
  g_is_leaving = true;
  RawTerminal::restore();
  raise(signal);
}

void restore_and_stop(int signal);

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction former {};
  sigaction(signal, nullptr, &former);
  // A signal that the parent wanted ignored, as `nohup` does, stays so; and somebody else's handler stays in its place.
  if (former.sa_handler != SIG_DFL && former.sa_handler != handler) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

void handle_stop() { handle(SIGTSTP, restore_and_stop, SA_RESETHAND | SA_NODEFER | SA_RESTART); }

void restore_and_stop(int signal) {
  const int error = errno;
  g_is_leaving = true;
  RawTerminal::restore();
  raise(signal);  // here the program rests until it is continued
  g_is_leaving = false;
  handle_stop();
  errno = error;
}

void unhandle(int signal, void (*handler)(int)) {
  struct sigaction present {};
  sigaction(signal, nullptr, &present);
  if (present.sa_handler != handler) return;
  present.sa_handler = SIG_DFL;
  present.sa_flags = 0;
  sigaction(signal, &present, nullptr);
}

}  // namespace

bool RawTerminal::exists() { return isatty(STDIN_FILENO) != 0; }

RawTerminal::RawTerminal() {
  for (const int signal : kDeadly) handle(signal, restore_and_die, SA_RESETHAND);
  handle_stop();
  enter();
}

RawTerminal::~RawTerminal() {
  restore();
  for (const int signal : kDeadly) unhandle(signal, restore_and_die);
  unhandle(SIGTSTP, restore_and_stop);
}

void RawTerminal::refresh() { enter(); }

void RawTerminal::restore() {
  // In the background the terminal is somebody else's, and touching it would stop the program.
  if (g_is_raw.exchange(false) && in_foreground()) tcsetattr(STDIN_FILENO, TCSANOW, &g_former);
}

}  // namespace firstlight::app
