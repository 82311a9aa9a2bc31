#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstddef>

namespace firstlight::render {

/// How many rays, hits or points are worked on side by side: enough for the widest vectors, few enough for their
/// numbers to stay in the nearest cache.
constexpr std::size_t kRaysAtOnce = 64;

/// One number of each of kRaysAtOnce rays. Not cleared when made: a short block is not to pay for the whole column, and
/// what is computed from lanes beyond its end is not used.
template <class T>
struct alignas(64) Column {
  std::array<T, kRaysAtOnce> at;

  T& operator[](std::size_t i) { return at[i]; }
  const T& operator[](std::size_t i) const { return at[i]; }
};

/// A number alone in its column. Vectors take its neighbours along, so these are the same: what happens to lie in memory
/// may be numbers that take long.
inline Column<double> alone(double number) {
  constexpr std::size_t kWidestVector = 64 / sizeof(double);
  Column<double> column;
  for (std::size_t i = 0; i < kWidestVector; ++i) column[i] = number;
  return column;
}

template <class T>
struct Columns2 {
  std::array<Column<T>, 2> of;

  template <class Vector>
  void set(std::size_t i, const Vector& v) {
    of[0][i] = v.x;
    of[1][i] = v.y;
  }
  Imath::Vec2<T> vector(std::size_t i) const { return {of[0][i], of[1][i]}; }
};

template <class T>
struct Columns3 {
  std::array<Column<T>, 3> of;

  template <class Vector>
  void set(std::size_t i, const Vector& v) {
    of[0][i] = v.x;
    of[1][i] = v.y;
    of[2][i] = v.z;
  }
  Imath::Vec3<T> vector(std::size_t i) const { return {of[0][i], of[1][i], of[2][i]}; }
};

}  // namespace firstlight::render
