#include "app/compare/process.h"

#include "app/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

namespace firstlight::app::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// Arguments and environment of a child, made ready before it is one: the child of a process of several threads may not
/// allocate.
class Launch {
 public:
  explicit Launch(const Command& command) : command_(command) {
    for (const std::string& word : command.words) arguments_.push_back(const_cast<char*>(word.c_str()));
    arguments_.push_back(nullptr);
    for (char** variable = environ; *variable != nullptr; ++variable) {
      const std::string_view text(*variable);
      if (text.starts_with("DISPLAY=") || (!command.home.empty() && text.starts_with("HOME="))) continue;
      environment_.push_back(*variable);
    }
    home_ = "HOME=" + command.home.string();
    if (!command.home.empty()) environment_.push_back(home_.data());
    environment_.push_back(nullptr);
  }

  /// In the child: becomes the program.
  [[noreturn]] void become(pid_t parent, int out, int err) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGPIPE, SIG_DFL);           // which we ignore
    if (getppid() != parent) _exit(127);  // it ended before it was asked for
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    if (chdir(command_.folder.c_str()) == 0) execvpe(arguments_[0], arguments_.data(), environment_.data());
    _exit(127);
  }

 private:
  const Command& command_;
  std::vector<char*> arguments_;
  std::vector<char*> environment_;
  std::string home_;
};

/// One of the child's streams, as it is read.
struct Stream {
  Descriptor in;
  std::string* text;

  /// Takes what is there without waiting.
  void take() {
    std::array<char, 65536> buffer;
    while (in.get() >= 0) {
      const ssize_t count = ::read(in.get(), buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno == EAGAIN) return;
      if (count <= 0) {
        in = Descriptor();
        return;
      }
      text->append(buffer.data(), static_cast<std::size_t>(count));
      // Twice as much as is kept, so that it is not moved for every piece.
      if (text->size() > 2 * kMostOutput) shorten();
    }
  }
  void shorten() {
    if (text->size() <= kMostOutput) return;
    constexpr std::string_view kGap = "\n[...]\n";
    constexpr std::size_t kHalf = kMostOutput / 2;
    text->replace(kHalf, text->size() - 2 * kHalf, kGap);
  }
};

std::string system_message() { return std::generic_category().message(errno); }

bool open_pipe(Descriptor& in, Descriptor& out) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
  in = Descriptor(ends[0]);
  out = Descriptor(ends[1]);
  return fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::string ProcessResult::summary() const {
  if (!error.empty()) return error;
  if (stopped) return fmt::format("stopped after {:.1f} s", seconds);
  if (timed_out) return fmt::format("stopped at the time limit, after {:.1f} s", seconds);
  if (signal != 0) return fmt::format("signal {} ({}) after {:.1f} s", signal, strsignal(signal), seconds);
  return fmt::format("exit code {} after {:.1f} s", exit_code, seconds);
}

ProcessResult run_process(const Command& command) {
  ProcessResult result;
  Launch launch(command);
  std::array<Stream, 2> streams{{{Descriptor(), &result.out}, {Descriptor(), &result.err}}};
  std::array<Descriptor, 2> ends;
  if (!open_pipe(streams[0].in, ends[0]) || !open_pipe(streams[1].in, ends[1])) {
    result.error = fmt::format("cannot run '{}': {}", command.words[0], system_message());
    return result;
  }
  const pid_t parent = getpid();
  const auto start = Clock::now();
  const pid_t child = fork();
  if (child < 0) {
    result.error = fmt::format("cannot run '{}': {}", command.words[0], system_message());
    return result;
  }
  if (child == 0) launch.become(parent, ends[0].get(), ends[1].get());
  setpgid(child, child);  // the child does so too; whichever is first
  for (Descriptor& end : ends) end = Descriptor();

  // The child's end wakes us by this, also when it, or what it left behind, treats the pipes in its own way.
  const Descriptor life(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  constexpr int kLook = 50;          // milliseconds, for a wish to stop
  constexpr int kLookForTheEnd = 5;  // where the system has no such descriptor
  const int most = life.get() >= 0 ? kLook : kLookForTheEnd;
  const auto has_ended = [&] {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
  };
  while (!has_ended()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(start + command.limit - Clock::now());
    result.stopped = command.stop != nullptr && *command.stop;
    result.timed_out = !result.stopped && left.count() <= 0;
    if (result.stopped || result.timed_out) break;
    std::array<pollfd, 3> waiting{
        {{streams[0].in.get(), POLLIN, 0}, {streams[1].in.get(), POLLIN, 0}, {life.get(), POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), static_cast<int>(std::min<std::int64_t>(left.count(), most)));
    for (Stream& stream : streams) stream.take();
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  kill(-child, SIGKILL);  // before it is collected: until then its number is not given to another
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  for (Stream& stream : streams) {
    stream.take();
    stream.shorten();
  }
  result.processor = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  result.peak_kilobytes = usage.ru_maxrss;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

std::optional<std::filesystem::path> find_program(const std::string& program) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto runs = [&](const fs::path& path) {
    return fs::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
  };
  if (program.empty()) return std::nullopt;
  if (program.find('/') != std::string::npos) {
    if (!runs(program)) return std::nullopt;
    return fs::absolute(program, ignored);
  }
  const char* const path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "/bin:/usr/bin";
  while (true) {
    const std::size_t colon = std::min(rest.find(':'), rest.size());
    const fs::path folder(colon == 0 ? std::string_view(".") : rest.substr(0, colon));
    if (runs(folder / program)) return fs::absolute(folder / program, ignored);
    if (colon == rest.size()) return std::nullopt;
    rest.remove_prefix(colon + 1);
  }
}

}  // namespace firstlight::app::compare
