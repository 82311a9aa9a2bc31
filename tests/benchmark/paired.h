#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace firstlight::benchmark {

// What is compared is paired: every round runs all programs one after the other, and a ratio is taken within its round,
// so that a machine that is slower for a minute is slower for all.

/// "8.20 (7.90 to 8.60)": median and range of above[i] / below[i].
std::string ratio_text(const std::vector<double>& above, const std::vector<double>& below);
/// POV-Ray's own measure in what it printed: `Trace Time: 0 hours 0 minutes 13 seconds (13.633 seconds)`; `label` is
/// "Trace Time:". Throws std::runtime_error when it is not there.
double povray_seconds(std::string_view label, const std::string& printed);

}  // namespace firstlight::benchmark
