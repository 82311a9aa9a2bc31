#pragma once

#include "render/function/function.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace firstlight::render {

/// How a spline goes from one of its points to the next.
enum class SplineKind {
  linear,
  quadratic,    ///< a parabola through the two points and the one before them
  natural,      ///< cubic, with continuous second derivatives
  catmull_rom,  ///< `cubic_spline`: passes its points but the first and last, which only give directions
};

/// A curve of 2 to 5 components over a parameter. Plain data, with what is worked out of it once.
///
/// Source   POV-Ray 3.7's interpolation, to the order of its operations.
/// Cost     O(log points) a value.
class Spline {
 public:
  static constexpr std::size_t kMostPoints = 1'000'000;
  using Values = std::array<double, 5>;
  struct Point {
    double at = 0.0;
    Values values{};
  };

  Spline() = default;
  /// `points` in any order; of several with one parameter the last counts, but for the highest parameter so far the
  /// first. [POV-Ray 3.7] Pre: not empty, parameters are finite.
  Spline(SplineKind kind, std::vector<Point> points, std::size_t components);

  SplineKind kind() const { return kind_; }
  std::size_t components() const { return components_; }
  const std::vector<Point>& points() const { return points_; }
  /// The same points with another way between them.
  Spline as(SplineKind kind) const;
  Values value(double at) const;

 private:
  void find_curvatures();
  double between(std::size_t end, std::size_t component, double at) const;
  double parabola(std::size_t middle, std::size_t component, double at) const;
  double hermite(std::size_t begin, std::size_t component, double at) const;
  double cubic(std::size_t begin, std::size_t component, double at) const;

  SplineKind kind_ = SplineKind::linear;
  std::size_t components_ = 2;
  std::vector<Point> points_;       ///< in rising order
  std::vector<Values> curvatures_;  ///< second derivatives at the points, of SplineKind::natural
};

/// The spline as a function of its parameter.
FunctionPtr make_spline_function(std::shared_ptr<const Spline> spline);

}  // namespace firstlight::render
