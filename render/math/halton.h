#pragma once

#include <cstdint>

namespace firstlight::render {

/// Number `index` of the Halton sequence of `base`, in (0, 1): the digits of index + 1 mirrored at the point.
/// Source   Halton, "On the efficiency of certain quasi-random sequences of points", Numerische Mathematik 2, 1960.
inline double halton(std::uint64_t index, std::uint32_t base) {
  double sum = 0.0;
  double place = 1.0 / base;
  for (std::uint64_t left = index + 1; left > 0; left /= base) {
    sum += static_cast<double>(left % base) * place;
    place /= base;
  }
  return sum;
}

}  // namespace firstlight::render
