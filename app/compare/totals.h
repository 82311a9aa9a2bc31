#pragma once

#include "app/compare/record.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

inline constexpr std::size_t kStatuses = 8;

/// A feature that scenes ask for and Firstlight cannot render.
struct FeatureCount {
  std::string feature;
  std::size_t scenes = 0;  ///< that ask for it
  std::size_t alone = 0;   ///< that lack nothing else
};

/// How many times as fast as POV-Ray, the median over the rounds. Nothing where a time is missing or too short for the
/// clock.
std::optional<double> trace_ratio(const SceneRecord& record);
std::optional<double> whole_ratio(const SceneRecord& record);

/// The outcome of many comparisons.
struct Totals {
  std::size_t scenes = 0;
  std::array<std::size_t, kStatuses> by_status{};
  std::optional<double> trace_ratio;  ///< geometric means of the scenes that both rendered
  std::optional<double> whole_ratio;
  std::size_t timed = 0;         ///< scenes that both rendered
  std::size_t slower_trace = 0;  ///< of those, where POV-Ray was sooner
  std::size_t slower_whole = 0;
  std::vector<FeatureCount> missing;  ///< the most wanted first

  std::size_t of(Status status) const { return by_status[static_cast<std::size_t>(status)]; }
};

Totals totals(std::span<const SceneRecord> records);

/// "agrees", "lacks features", of several scenes "agree", "lack features": as people are told.
std::string_view status_text(Status status, std::size_t scenes = 1);

/// A few lines, the last with an end of line.
std::string to_text(const Totals& totals);

}  // namespace firstlight::app::compare
