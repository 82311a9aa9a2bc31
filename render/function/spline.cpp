#include "render/function/spline.h"

#include <algorithm>
#include <map>
#include <utility>

namespace firstlight::render {
namespace {

class SplineFunction final : public Function {
 public:
  explicit SplineFunction(std::shared_ptr<const Spline> spline)
      : Function(1, spline->components(), 100), spline_(std::move(spline)) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    const Spline::Values values = spline_->value(arguments[0]);
    std::copy_n(values.begin(), result_count(), results);
  }

 private:
  std::shared_ptr<const Spline> spline_;
};

}  // namespace

Spline::Spline(SplineKind kind, std::vector<Point> points, std::size_t components)
    : kind_(kind), components_(components) {
  std::map<double, Point> sorted;
  for (const Point& point : points) {
    const bool repeats_last = sorted.size() > 1 && sorted.rbegin()->first == point.at;
    if (!repeats_last) sorted[point.at] = point;
  }
  for (const auto& [at, point] : sorted) points_.push_back(point);
  find_curvatures();
}

Spline Spline::as(SplineKind kind) const {
  Spline other = *this;
  other.kind_ = kind;
  other.find_curvatures();
  return other;
}

/// The tridiagonal system of a natural cubic spline, solved from both ends.
void Spline::find_curvatures() {
  if (kind_ != SplineKind::natural || !curvatures_.empty() || points_.size() < 2) return;
  const std::size_t last = points_.size() - 1;
  curvatures_.assign(points_.size(), Values{});
  std::vector<double> step(last), slope(last), pivot(last), right(last);
  for (std::size_t k = 0; k < 5; ++k) {
    for (std::size_t i = 0; i < last; ++i) {
      step[i] = points_[i + 1].at - points_[i].at;
      slope[i] = (points_[i + 1].values[k] - points_[i].values[k]) / step[i];
    }
    for (std::size_t i = 1; i < last; ++i) {
      pivot[i] = 2 * (step[i] + step[i - 1]);
      right[i] = 6 * (slope[i] - slope[i - 1]);
      if (i == 1) continue;
      pivot[i] -= step[i - 1] * step[i - 1] / pivot[i - 1];
      right[i] -= step[i - 1] * right[i - 1] / pivot[i - 1];
    }
    for (std::size_t i = last; i-- > 1;) {
      curvatures_[i][k] = (right[i] - step[i] * curvatures_[i + 1][k]) / pivot[i];
    }
  }
}

Spline::Values Spline::value(double at) const {
  Values values{};
  if (points_.empty()) return values;
  if (points_.size() == 1) return points_[0].values;
  // The first point that is not below, as the end of the piece; before the first it is 0, from the last on the size.
  std::size_t end = points_.size();
  if (!(at >= points_.back().at)) {
    const auto found = std::lower_bound(points_.begin(), points_.end(), at,
                                        [](const Point& point, double value) { return point.at < value; });
    end = static_cast<std::size_t>(found - points_.begin());
  }
  for (std::size_t k = 0; k < 5; ++k) values[k] = between(end, k, at);
  return values;
}

double Spline::between(std::size_t end, std::size_t k, double at) const {
  const std::size_t last = points_.size() - 1;
  if (kind_ == SplineKind::catmull_rom) {
    if (last == 1) return (points_[0].values[k] + points_[1].values[k]) / 2.0;
    if (end < 2) return points_[1].values[k];
    if (end >= last) return points_[last - 1].values[k];
    return hermite(end - 1, k, at);
  }
  if (end == 0) return points_[0].values[k];
  if (end > last) return points_[last].values[k];
  if (kind_ == SplineKind::natural) return cubic(end - 1, k, at);
  if (kind_ == SplineKind::quadratic && last > 1) return parabola(end > 1 ? end - 1 : end, k, at);
  const Point &a = points_[end - 1], &b = points_[end];
  return (at - a.at) * (b.values[k] - a.values[k]) / (b.at - a.at) + a.values[k];
}

/// Through a point and its neighbours.
double Spline::parabola(std::size_t middle, std::size_t k, double at) const {
  const double p1 = points_[middle - 1].at, p2 = points_[middle].at, p3 = points_[middle + 1].at;
  const double v1 = points_[middle - 1].values[k], v2 = points_[middle].values[k], v3 = points_[middle + 1].values[k];
  const double n = (p2 - p1) * (p3 - p1) * (p3 - p2);
  const double a = (-p2 * v1 + p3 * v1 + p1 * v2 - p3 * v2 - p1 * v3 + p2 * v3) / n;
  const double b = (p2 * p2 * v1 - p3 * p3 * v1 - p1 * p1 * v2 + p3 * p3 * v2 + p1 * p1 * v3 - p2 * p2 * v3) / n;
  const double c = (-p2 * p2 * p3 * v1 + p2 * p3 * p3 * v1 + p1 * p1 * p3 * v2 - p1 * p3 * p3 * v2 - p1 * p1 * p2 * v3 +
                    p1 * p2 * p2 * v3) /
                   n;
  return (a * at + b) * at + c;
}

/// Between two points, with the mean slope of the pieces beside each.
double Spline::hermite(std::size_t begin, std::size_t k, double at) const {
  const auto slope = [&](std::size_t i) {
    return (points_[i + 1].values[k] - points_[i].values[k]) / (points_[i + 1].at - points_[i].at);
  };
  const double width = points_[begin + 1].at - points_[begin].at;
  const double u = (at - points_[begin].at) / width;
  const double from = (slope(begin - 1) + slope(begin)) / 2.0 * width;
  const double to = (slope(begin + 1) + slope(begin)) / 2.0 * width;
  return points_[begin].values[k] * (2 * u * u * u - 3 * u * u + 1) +
         points_[begin + 1].values[k] * (3 * u * u - 2 * u * u * u) + from * (u * u * u - 2 * u * u + u) +
         to * (u * u * u - u * u);
}

double Spline::cubic(std::size_t begin, std::size_t k, double at) const {
  const Point &a = points_[begin], &b = points_[begin + 1];
  const double curve_a = curvatures_[begin][k], curve_b = curvatures_[begin + 1][k];
  const double width = b.at - a.at, along = at - a.at;
  const double bend = curve_a / 2.0 + along * (curve_b - curve_a) / (6.0 * width);
  const double slope = -(width / 6.0) * (curve_b + 2.0 * curve_a) + (b.values[k] - a.values[k]) / width + along * bend;
  return a.values[k] + along * slope;
}

FunctionPtr make_spline_function(std::shared_ptr<const Spline> spline) {
  return std::make_shared<SplineFunction>(std::move(spline));
}

}  // namespace firstlight::render
