#include "render/shape/root_search.h"

#include "render/math/interrupt.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// A search that needs more finds nothing. A field that is 0 all along a ray is asked at every step of the accuracy.
constexpr int kMostEvaluations = 1'000'000;

}  // namespace

std::vector<RootSearch::Stretch>& RootSearch::waiting() {
  thread_local std::vector<Stretch> stretches;
  return stretches;
}

std::optional<double> RootSearch::first(double begin, double at_begin, double end, double at_end, double high) {
  std::vector<Stretch>& all = waiting();
  all.clear();
  evaluations_ = 0;
  if (gradient_.evaluate != nullptr && gradient_.most > (*gradient_.evaluate)[0]) {
    gradient_.most *= (*gradient_.evaluate)[2];
  }
  const double length = end - begin;
  const double climb = gradient_.most * speed_ * length;
  if (gradient_.evaluate != nullptr) return learning({begin, at_begin, end, at_end, length, climb, false});
  add(begin, at_begin, end, at_end, length, climb, high);
  while (!all.empty()) {
    if (all.back().is_found) return all.back().end;
    if (evaluations_ > kMostEvaluations || Interrupt::asked()) break;
    halve_some(high);
  }
  return std::nullopt;
}

/// Keeps what is to be halved or is an answer.
inline void RootSearch::add(double begin, double at_begin, double end, double at_end, double length, double climb,
                            double high) {
  const bool is_short = length < accuracy_;
  const bool counts = is_short ? at_end < 0.0 : at_begin + at_end - climb < 0.0;
  if (counts && begin <= high) waiting().push_back({begin, at_begin, end, at_end, length, climb, is_short});
}

inline void RootSearch::halve(const Stretch& whole, double middle, double at_middle, double high) {
  const double length = 0.5 * whole.length;
  const double climb = 0.5 * whole.climb;
  add(middle, at_middle, whole.end, whole.at_end, length, climb, high);
  add(whole.begin, whole.at_begin, middle, at_middle, length, climb, high);
}

/// Halves the nearest stretch, and those behind it that will be looked at unless a root turns up before them: up to one
/// that ends below 0, for there one is to be expected.
void RootSearch::halve_some(double high) {
  std::vector<Stretch>& all = waiting();
  std::size_t first = all.size() - 1;
  while (first > 0 && all.size() - first < kFieldPoints && !(all[first].at_end < 0.0) && !all[first - 1].is_found) {
    --first;
  }
  const std::size_t count = all.size() - first;
  evaluations_ += static_cast<int>(count);
  if (count == 1) {
    const Stretch whole = all.back();
    all.pop_back();
    const double middle = whole.begin + 0.5 * whole.length;
    halve(whole, middle, field_.at(middle), high);
    return;
  }
  std::array<Stretch, kFieldPoints> taken;
  FieldColumn middles;
  FieldColumn values;
  std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), count, taken.begin());
  all.resize(first);
  for (std::size_t i = 0; i < count; ++i) middles[i] = taken[i].begin + 0.5 * taken[i].length;
  field_.at({middles.data(), count}, values);
  for (std::size_t i = 0; i < count; ++i) halve(taken[i], middles[i], values[i], high);
}

/// Looks at one stretch after the other: what the nearer half teaches of the gradient counts in the further one.
std::optional<double> RootSearch::learning(const Stretch& whole) {
  const std::array<double, 3>& evaluate = *gradient_.evaluate;
  std::vector<Stretch>& all = waiting();
  all.push_back(whole);
  while (!all.empty()) {
    Stretch s = all.back();
    all.pop_back();
    const double met = std::abs((s.at_end - s.at_begin) / (speed_ * s.length));
    if (gradient_.most < met * evaluate[1]) {
      gradient_.most = met * evaluate[1] * evaluate[1];
      s.climb = gradient_.most * speed_ * s.length;
    }
    if (s.length < accuracy_) {
      if (s.at_end < 0.0) return s.end;
    } else if (s.at_begin + s.at_end - s.climb < 0.0) {
      if (++evaluations_ > kMostEvaluations || Interrupt::asked()) break;
      const double middle = s.begin + 0.5 * s.length;
      const double at_middle = field_.at(middle);
      all.push_back({middle, at_middle, s.end, s.at_end, 0.5 * s.length, 0.5 * s.climb, false});
      all.push_back({s.begin, s.at_begin, middle, at_middle, 0.5 * s.length, 0.5 * s.climb, false});
    }
  }
  return std::nullopt;
}

}  // namespace firstlight::render
