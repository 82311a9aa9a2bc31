#pragma once

namespace firstlight::render {

// POV-Ray 3.7's own limits; a picture agrees with it only when the same crossings count.

constexpr double kEpsilon = 1e-10;         ///< what counts as zero in directions and inside tests
constexpr double kMaxDistance = 1e7;       ///< most shapes are not seen from farther away
constexpr double kNearestCrossing = 1e-6;  ///< nearer crossings of most shapes are the surface that a ray starts on
constexpr double kBoundingHuge = 2e10;     ///< depth without end, in slab tests

}  // namespace firstlight::render
