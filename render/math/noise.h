#pragma once

#include "render/math/vec.h"

namespace firstlight::render {

/// The sum of noise at several sizes that turbulence is. Lambda and omega are kept in single precision, as POV-Ray
/// does.
struct Octaves {
  int count = 6;
  float lambda = 2.0f;  ///< each octave is so many times as fine as the one before
  float omega = 0.5f;   ///< and so many times as strong
};

// Smooth random fields over space, the same in every run. `generator` is that of the scene language: 0 and 1 the
// original noise, 2 the original with its range corrected, 3 gradient noise. Values and rounding are POV-Ray 3.7's.
// Cost: about 50 ns a value, and as much for each octave.

/// A number from 0 to 4095 of the lattice's cell whose lowest corner is given, in whole numbers.
unsigned lattice_hash(double x, double y, double z);

/// In [0, 1].
double noise(const Vec3& point, int generator);
/// A vector of which each component is a noise of its own, about [-0.5, 0.5]. It has no generators.
Vec3 dnoise(const Vec3& point);
/// From 0 up; the sum may exceed 1.
double turbulence(const Vec3& point, const Octaves& octaves, int generator);
Vec3 dturbulence(const Vec3& point, const Octaves& octaves);

}  // namespace firstlight::render
