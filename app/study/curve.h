#pragma once

#include <optional>
#include <span>

namespace firstlight::app {

struct CurvePoint {
  double x = 0.0;
  double y = 0.0;
};

/// The area under straight lines from point to point. Pre: x does not decrease.
double area_under(std::span<const CurvePoint> curve);

/// The least x from which on the curve does not exceed `limit` again; nothing when it ends above.
std::optional<double> settles_below(std::span<const CurvePoint> curve, double limit);

/// On the straight lines from point to point; before the first and behind the last point as there. Pre: not empty.
double value_at(std::span<const CurvePoint> curve, double x);

/// The middle value; the mean of the two in the middle where their number is even. Pre: not empty.
double median(std::span<const double> values);

}  // namespace firstlight::app
