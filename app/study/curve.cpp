#include "app/study/curve.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace firstlight::app {

double area_under(std::span<const CurvePoint> curve) {
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    area += (curve[i].x - curve[i - 1].x) * (curve[i].y + curve[i - 1].y) / 2.0;
  }
  return area;
}

std::optional<double> settles_below(std::span<const CurvePoint> curve, double limit) {
  if (curve.empty() || curve.back().y > limit) return std::nullopt;
  std::size_t first = curve.size() - 1;
  while (first > 0 && curve[first - 1].y <= limit) --first;
  if (first == 0) return curve[0].x;
  const CurvePoint& above = curve[first - 1];
  const CurvePoint& below = curve[first];
  return above.x + (below.x - above.x) * (above.y - limit) / (above.y - below.y);
}

double value_at(std::span<const CurvePoint> curve, double x) {
  const auto after = std::ranges::upper_bound(curve, x, {}, &CurvePoint::x);
  if (after == curve.begin()) return curve.front().y;
  if (after == curve.end()) return curve.back().y;
  const CurvePoint& before = *(after - 1);
  return before.y + (after->y - before.y) * (x - before.x) / (after->x - before.x);
}

double median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2.0;
}

}  // namespace firstlight::app
