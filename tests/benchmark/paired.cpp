#include "tests/benchmark/paired.h"

#include "app/study/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace firstlight::benchmark {

std::string ratio_text(const std::vector<double>& above, const std::vector<double>& below) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.size(); ++i) ratios.push_back(above[i] / below[i]);
  const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", app::median(ratios), *least, *most);
}

double povray_seconds(std::string_view label, const std::string& printed) {
  const std::size_t line = printed.find(label);
  const std::size_t number = line == std::string::npos ? line : printed.find('(', line);
  double seconds = 0;
  if (number == std::string::npos ||
      std::from_chars(printed.data() + number + 1, printed.data() + printed.size(), seconds).ec != std::errc()) {
    throw std::runtime_error(fmt::format("POV-Ray printed no '{}'", label));
  }
  return seconds;
}

}  // namespace firstlight::benchmark
