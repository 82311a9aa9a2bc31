#include "app/process_start.h"

#include <time.h>
#include <unistd.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <string>

namespace firstlight::app {
namespace {

/// Field 22 of /proc/self/stat: clock ticks from boot to the start of the process; -1 when it cannot be read.
long long start_ticks() {
  std::ifstream file("/proc/self/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  // The second field, a name in parentheses, may hold blanks; the fields behind it do not.
  std::size_t at = text.rfind(')');
  for (int field = 2; field < 22 && at != std::string::npos; ++field) at = text.find(' ', at + 1);
  long long ticks = -1;
  if (at != std::string::npos) std::from_chars(text.data() + at + 1, text.data() + text.size(), ticks);
  return ticks;
}

}  // namespace

std::chrono::steady_clock::time_point process_start() {
  const auto now = std::chrono::steady_clock::now();
  const long long ticks = start_ticks();
  const long ticks_a_second = sysconf(_SC_CLK_TCK);
  timespec boot{};
  if (ticks < 0 || ticks_a_second <= 0 || clock_gettime(CLOCK_BOOTTIME, &boot) != 0) return now;
  const double age = static_cast<double>(boot.tv_sec) + 1e-9 * static_cast<double>(boot.tv_nsec) -
                     static_cast<double>(ticks) / static_cast<double>(ticks_a_second);
  if (age <= 0.0) return now;
  return now - std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(age));
}

}  // namespace firstlight::app
