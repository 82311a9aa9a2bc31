#include "app/compare/totals.h"

#include "app/compare/record_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace firstlight::app::compare {
namespace {

/// The median over the rounds.
std::optional<double> ratio(const SceneRecord& record, std::string_view measure) {
  const auto row = std::ranges::find(measures(), measure, &Measure::name);
  const std::vector<double> found = ratios(record, *row);
  if (found.empty()) return std::nullopt;
  const double middle = spread_of(found).median;
  return middle > 0.0 ? std::optional(middle) : std::nullopt;
}

/// The geometric mean of numbers that come one by one.
struct GeometricMean {
  double logs = 0.0;
  std::size_t count = 0;

  void add(double value) {
    logs += std::log(value);
    ++count;
  }
  std::optional<double> value() const {
    return count > 0 ? std::optional(std::exp(logs / static_cast<double>(count))) : std::nullopt;
  }
};

std::string times_as_fast(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.2f} times as fast", *ratio) : std::string("not known");
}

}  // namespace

std::optional<double> trace_ratio(const SceneRecord& record) { return ratio(record, "trace_s"); }
std::optional<double> whole_ratio(const SceneRecord& record) { return ratio(record, "wall_s"); }

Totals totals(std::span<const SceneRecord> records) {
  Totals sum;
  sum.scenes = records.size();
  GeometricMean trace;
  GeometricMean whole;
  std::map<std::string, FeatureCount> features;
  for (const SceneRecord& record : records) {
    ++sum.by_status[static_cast<std::size_t>(record.status)];
    if (!record.povray.empty() && !record.ours.empty()) ++sum.timed;
    if (const auto ratio = trace_ratio(record)) {
      trace.add(*ratio);
      if (*ratio < 1.0) ++sum.slower_trace;
    }
    if (const auto ratio = whole_ratio(record)) {
      whole.add(*ratio);
      if (*ratio < 1.0) ++sum.slower_whole;
    }
    std::set<std::string> wanted;
    for (const MissingFeature& missing : record.missing) wanted.insert(missing.feature);
    for (const std::string& feature : wanted) {
      FeatureCount& count = features[feature];
      count.feature = feature;
      ++count.scenes;
      if (wanted.size() == 1) ++count.alone;
    }
  }
  sum.trace_ratio = trace.value();
  sum.whole_ratio = whole.value();
  for (auto& [name, count] : features) sum.missing.push_back(std::move(count));
  std::ranges::stable_sort(sum.missing, [](const FeatureCount& a, const FeatureCount& b) {
    return a.scenes != b.scenes ? a.scenes > b.scenes : a.alone > b.alone;
  });
  return sum;
}

std::string_view status_text(Status status, std::size_t scenes) {
  const bool one = scenes == 1;
  switch (status) {
    case Status::agrees:
      return one ? "agrees" : "agree";
    case Status::warns:
      return one ? "agrees in means" : "agree in means";
    case Status::differs:
      return one ? "differs" : "differ";
    case Status::other_size:
      return "other size";
    case Status::lacks_features:
      return one ? "lacks features" : "lack features";
    case Status::ours_failed:
      return "Firstlight failed";
    case Status::povray_failed:
      return "POV-Ray failed";
    case Status::both_failed:
      return "both failed";
  }
  return "";
}

std::string to_text(const Totals& totals) {
  std::string text = fmt::format("{} scene{}:", totals.scenes, totals.scenes == 1 ? "" : "s");
  const char* between = " ";
  for (std::size_t i = 0; i < kStatuses; ++i) {
    if (totals.by_status[i] == 0) continue;
    text +=
        fmt::format("{}{} {}", between, totals.by_status[i], status_text(static_cast<Status>(i), totals.by_status[i]));
    between = ", ";
  }
  text += '\n';
  if (totals.timed > 0) {
    text += fmt::format(
        "of {} that both rendered, by geometric means: tracing {}, the whole process {}\n"
        "slower than POV-Ray: tracing in {}, the whole process in {}\n",
        totals.timed, times_as_fast(totals.trace_ratio), times_as_fast(totals.whole_ratio), totals.slower_trace,
        totals.slower_whole);
  }
  if (!totals.missing.empty()) text += "missing:  scenes  nothing else\n";
  for (const FeatureCount& count : totals.missing) {
    text += fmt::format("          {:6}  {:12}  {}\n", count.scenes, count.alone, count.feature);
  }
  return text;
}

}  // namespace firstlight::app::compare
