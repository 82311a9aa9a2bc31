#include "app/memory_size.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <charconv>
#include <cmath>

namespace firstlight::app {
namespace {

constexpr std::string_view kLetters = "KMGT";

}  // namespace

std::optional<std::size_t> parse_memory_size(std::string_view text) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) == 0) return std::nullopt;
  double value = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  std::string_view unit(end, static_cast<std::size_t>(last - end));
  double factor = 1.0;
  if (!unit.empty()) {
    const std::size_t power = kLetters.find(static_cast<char>(std::toupper(static_cast<unsigned char>(unit[0]))));
    if (power != std::string_view::npos) {
      factor = std::pow(1024.0, static_cast<double>(power + 1));
      unit.remove_prefix(1);
      if (unit == "iB" || unit == "ib") unit = {};
    }
    if (unit == "B" || unit == "b") unit = {};
  }
  const double bytes = std::floor(value * factor);
  // Doubles are exact up to 2^53, and no machine has more.
  if (!unit.empty() || !(bytes <= 9007199254740992.0)) return std::nullopt;
  return static_cast<std::size_t>(bytes);
}

std::string short_memory_size(std::size_t bytes) {
  if (bytes < 1024) return fmt::format("{} bytes", bytes);
  double value = static_cast<double>(bytes) / 1024.0;
  std::size_t power = 0;
  for (; value >= 1024.0 && power + 1 < kLetters.size(); ++power) value /= 1024.0;
  return fmt::format("{:.3g} {}", value, power == 0 ? 'k' : kLetters[power]);
}

std::size_t default_queue_memory() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_size = sysconf(_SC_PAGESIZE);
  return pages > 0 && page_size > 0 ? static_cast<std::size_t>(pages) / 4 * static_cast<std::size_t>(page_size) : 0;
}

}  // namespace firstlight::app
