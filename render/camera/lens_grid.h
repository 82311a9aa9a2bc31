#pragma once

#include <functional>
#include <vector>

namespace firstlight::render {

/// Their number is bounded: they take memory, and their choice time.
constexpr int kMostLensPoints = 65536;

/// A point of the lens, of an aperture of 1 around (0, 0).
struct LensPoint {
  double x;
  double y;
};

/// Where the rays of focal blur pass through the lens, in their order.
struct LensGrid {
  std::vector<LensPoint> points;
  double most_jitter;  ///< by which each ray's point moves, at most, in both directions
};

// Pre: 1 <= samples <= kMostLensPoints.

/// `samples` points of a round lens: 4, 7, 19 or 37 of fixed places, the largest number that is not too large, then places
/// of a quasi-random sequence that are far from those before.
/// Source   POV-Ray 3.7: the same points.
LensGrid round_lens(int samples);
/// Points of a lens over the unit square, the more the larger `light` (x, y) is there, x and y from 0 to 1; 1 takes every
/// point that is offered.
LensGrid shaped_lens(int samples, const std::function<double(double, double)>& light);

}  // namespace firstlight::render
