// Noise over a lane type; render/math/noise.h says what it is. Included once for each instruction set, so the guard
// switches back and forth.
//
// Tables are looked up lane by lane: that is no slower than a vector's own gathering. Rows of four coefficients are
// loaded for each lane, and turned into columns. Neighbours in a picture often lie in one cell of the lattice, whose
// corners are then looked up once for all lanes.
#if defined(FIRSTLIGHT_RENDER_MATH_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_MATH_NOISE_INL_H
#undef FIRSTLIGHT_RENDER_MATH_NOISE_INL_H
#else
#define FIRSTLIGHT_RENDER_MATH_NOISE_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/math/noise.h"
#include "render/math/noise_tables.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Added to a whole number below 2^51 in size, it leaves that in the low bits of the sum.
constexpr double kToBits = 6755399441055744.0;  // 1.5 * 2^52

/// As POV-Ray's processors cut numbers: what does not fit becomes the lowest integer.
template <class L>
HWY_INLINE L cut(const L& value) {
  const MaskOf<L> fits = (value > -2147483649.0) & (value < 2147483648.0);
  return select(fits, trunc(value), L(-2147483648.0));
}

/// a^2 (3 - 2a): from 0 to 1, level at both ends.
template <class L>
HWY_INLINE L s_curve(const L& a) {
  return a * a * (3.0 - 2.0 * a);
}

/// A place in a lattice along one axis.
template <class L>
struct LatticeStep {
  unsigned point[L::kCount];  ///< the number of the point below
  L from;                     ///< the way from it, 0 to 1
};

/// point[i] is number `whole` + `origin` of a table of 2^n that begins anew at its end.
template <class L>
HWY_INLINE void number_points(const L& whole, unsigned origin, unsigned size, unsigned (&point)[L::kCount]) {
  std::int64_t numbers[L::kCount];
  store_bits(whole + kToBits, numbers);
  for (std::size_t i = 0; i < L::kCount; ++i) point[i] = (static_cast<unsigned>(numbers[i]) + origin) & (size - 1);
}

template <class L>
HWY_INLINE void step(const L& x, LatticeStep<L>& to) {
  constexpr double kAlmostOne = 1.0 - 1e-10;
  const L whole = cut(select(x >= 0.0, x, x - kAlmostOne));
  number_points(whole, 10000, LatticeTables::kPoints, to.point);
  to.from = x - whole;
}

/// Whether all lanes are between the same points.
template <class L>
HWY_INLINE bool is_one_cell(const LatticeStep<L>& x, const LatticeStep<L>& y, const LatticeStep<L>& z) {
  unsigned differences = 0;
  for (std::size_t i = 1; i < L::kCount; ++i) {
    differences |= (x.point[i] ^ x.point[0]) | (y.point[i] ^ y.point[0]) | (z.point[i] ^ z.point[0]);
  }
  return differences == 0;
}

/// find(i) for each lane, or for the first alone where all are in one cell.
template <class L, class Find>
HWY_INLINE void for_each_cell(bool is_one, const Find& find) {
  if (is_one) return find(0);
  for (std::size_t i = 0; i < L::kCount; ++i) find(i);
}

/// Where the coefficients of the corners of cells begin, by lanes; of one cell for all lanes, in the first.
template <class L>
using Corners = std::int32_t[8][L::kCount];

/// Whether all lanes are in one cell is known where this is compiled: corners are asked in the innermost loops.
template <bool kOneCell, class L>
HWY_INLINE void load_corner(const double* coefficients, const std::int32_t (&corner)[L::kCount], L (&c)[4]) {
  if constexpr (kOneCell) {
    for (std::size_t i = 0; i < 4; ++i) c[i] = coefficients[static_cast<std::size_t>(corner[0]) + i];
  } else {
    load_rows(coefficients, corner, c);
  }
}

/// The corners of the lattice's cells about points.
template <class L>
struct LatticeCell {
  Corners<L> corners;
  bool is_one;                     ///< for all lanes
  L weight[8];                     ///< of each of them
  L way_x[2], way_y[2], way_z[2];  ///< from corners on either side
};

template <class L>
HWY_INLINE void enter_cell(const Vec3Of<L>& p, LatticeCell<L>& cell) {
  const LatticeTables& tables = LatticeTables::get();
  LatticeStep<L> x, y, z;
  step(p.x, x);
  step(p.y, y);
  step(p.z, z);
  cell.is_one = is_one_cell(x, y, z);
  const auto find_corners = [&](std::size_t i) HWY_ATTR {
    const unsigned left = tables.permutation[x.point[i]], right = tables.permutation[x.point[i] + 1];
    const unsigned row = y.point[i], layer = z.point[i];
    const unsigned column[4] = {tables.permutation[left ^ row], tables.permutation[right ^ row],
                                tables.permutation[left ^ (row + 1)], tables.permutation[right ^ (row + 1)]};
    for (unsigned k = 0; k < 4; ++k) {
      cell.corners[k][i] = tables.entry[column[k] ^ layer];
      cell.corners[k + 4][i] = tables.entry[column[k] ^ (layer + 1)];
    }
  };
  for_each_cell<L>(cell.is_one, find_corners);
  const L to_x = s_curve(x.from), to_y = s_curve(y.from), to_z = s_curve(z.from);
  const L weight_xy[4] = {(1.0 - to_x) * (1.0 - to_y), to_x * (1.0 - to_y), (1.0 - to_x) * to_y, to_x * to_y};
  for (std::size_t k = 0; k < 4; ++k) {
    cell.weight[k] = weight_xy[k] * (1.0 - to_z);
    cell.weight[k + 4] = weight_xy[k] * to_z;
  }
  cell.way_x[0] = x.from;
  cell.way_y[0] = y.from;
  cell.way_z[0] = z.from;
  cell.way_x[1] = x.from - 1.0;
  cell.way_y[1] = y.from - 1.0;
  cell.way_z[1] = z.from - 1.0;
}

/// Corner k's share of a sum: a linear function of the way from it, its first coefficient halved, times its weight.
template <bool kOneCell, class L>
HWY_INLINE L corner_share(const LatticeCell<L>& cell, std::size_t k, const double* coefficients) {
  L c[4];
  load_corner<kOneCell>(coefficients, cell.corners[k], c);
  return cell.weight[k] *
         (c[0] * 0.5 + c[1] * cell.way_x[k & 1] + c[2] * cell.way_y[k >> 1 & 1] + c[3] * cell.way_z[k >> 2]);
}

template <bool kOneCell, class L>
HWY_INLINE L sum_of_corners(const LatticeCell<L>& cell) {
  const double* coefficients = LatticeTables::get().coefficients.data();
  L sum = 0.0;
  for (std::size_t k = 0; k < 8; ++k) sum = sum + corner_share<kOneCell>(cell, k, coefficients);
  return sum;
}

template <class L>
HWY_INLINE L lattice_noise(const Vec3Of<L>& p) {
  LatticeCell<L> cell;
  enter_cell(p, cell);
  return cell.is_one ? sum_of_corners<true>(cell) : sum_of_corners<false>(cell);
}

/// A place between two entries of the gradients along one axis.
template <class L>
HWY_INLINE void gradient_step(const L& x, LatticeStep<L>& to) {
  constexpr double kFarFromZero = 10000000.023157213;  // keeps scenes away from the table's symmetry about 0
  const L shifted = x + kFarFromZero;
  const L whole = cut(floor(shifted));
  number_points(whole, 0, GradientTables::kSize, to.point);
  to.from = shifted - whole;
}

template <class L>
HWY_INLINE L blend(const L& t, const L& a, const L& b) {
  return a + t * (b - a);
}

template <class L>
HWY_INLINE L gradient_noise(const Vec3Of<L>& p) {
  const GradientTables& tables = GradientTables::get();
  LatticeStep<L> x, y, z;
  gradient_step(p.x, x);
  gradient_step(p.y, y);
  gradient_step(p.z, z);
  Corners<L> corners;
  const auto find_corners = [&](std::size_t i) HWY_ATTR {
    constexpr unsigned kWithin = GradientTables::kSize - 1;
    const unsigned columns[2] = {tables.permutation[x.point[i]], tables.permutation[(x.point[i] + 1) & kWithin]};
    const unsigned rows[2] = {y.point[i], (y.point[i] + 1) & kWithin};
    const unsigned layers[2] = {z.point[i], (z.point[i] + 1) & kWithin};
    for (unsigned k = 0; k < 8; ++k) {
      const unsigned gradient = tables.permutation[columns[k & 1] + rows[k >> 1 & 1]] + layers[k >> 2];
      corners[k][i] = static_cast<std::int32_t>(4 * gradient);
    }
  };
  const bool is_one = is_one_cell(x, y, z);
  for_each_cell<L>(is_one, find_corners);
  const L way_x[2] = {x.from, x.from - 1.0}, way_y[2] = {y.from, y.from - 1.0}, way_z[2] = {z.from, z.from - 1.0};
  const L to_x = s_curve(x.from), to_y = s_curve(y.from), to_z = s_curve(z.from);
  L edge[4];
  for (std::size_t k = 0; k < 4; ++k) {
    L end[2];
    for (std::size_t side = 0; side < 2; ++side) {
      L g[4];
      const double* gradients = tables.gradients.front().data();
      if (is_one) {
        load_corner<true>(gradients, corners[2 * k + side], g);
      } else {
        load_corner<false>(gradients, corners[2 * k + side], g);
      }
      end[side] = way_x[side] * g[0] + way_y[k & 1] * g[1] + way_z[k >> 1] * g[2];
    }
    edge[k] = blend(to_x, end[0], end[1]);
  }
  return blend(to_z, blend(to_y, edge[0], edge[1]), blend(to_y, edge[2], edge[3]));
}

// Vectors are handed over in memory where functions are not inlined.
template <class L>
HWY_NOINLINE void lattice_noise_of(const Vec3Of<L>& p, L& value) {
  value = lattice_noise(p);
}
template <class L>
HWY_NOINLINE void gradient_noise_of(const Vec3Of<L>& p, L& value) {
  value = gradient_noise(p);
}

template <class L>
HWY_INLINE L noise(const Vec3Of<L>& p, int generator) {
  L value;
  if (generator == 3) {
    gradient_noise_of(p, value);
    value = 0.5 * (1.59 * value + 0.985);
  } else {
    lattice_noise_of(p, value);
    // The sum lies between -1.05242 and 0.988997. [POV-Ray 3.7]
    value = generator == 2 ? (value + 1.05242) * 0.48985582 : value + 0.5;
  }
  return clamp(value, 0.0, 1.0);
}

/// Sums depend on their order in the last digit, and POV-Ray goes about the corners in another order than for noise.
template <bool kOneCell, class L>
HWY_INLINE Vec3Of<L> sums_around(const LatticeCell<L>& cell) {
  constexpr std::size_t kRound[8] = {0, 1, 3, 2, 6, 7, 5, 4};
  const double* coefficients = LatticeTables::get().coefficients.data();
  Vec3Of<L> sum = {L(0.0), L(0.0), L(0.0)};
  for (const std::size_t k : kRound) {
    sum.x = sum.x + corner_share<kOneCell>(cell, k, coefficients);
    sum.y = sum.y + corner_share<kOneCell>(cell, k, coefficients + 4);
    sum.z = sum.z + corner_share<kOneCell>(cell, k, coefficients + 8);
  }
  return sum;
}

template <class L>
HWY_NOINLINE void dnoise_of(const Vec3Of<L>& p, Vec3Of<L>& value) {
  LatticeCell<L> cell;
  enter_cell(p, cell);
  value = cell.is_one ? sums_around<true>(cell) : sums_around<false>(cell);
}
template <class L>
HWY_INLINE Vec3Of<L> dnoise(const Vec3Of<L>& p) {
  Vec3Of<L> value;
  dnoise_of(p, value);
  return value;
}

template <class L>
HWY_INLINE L turbulence(const Vec3Of<L>& p, const Octaves& octaves, int generator) {
  // The newer generators are spread to the range of the original.
  double size = 1.0, strength = 1.0;
  L sum = 0.0;
  for (int octave = 1; octave == 1 || octave <= octaves.count; ++octave) {
    L value = noise(p * L(size), generator);
    if (generator > 1) value = 2.0 * value - 0.5;
    sum = octave == 1 ? clamp(value, 0.0, 1.0) : sum + strength * value;
    size *= octaves.lambda;
    strength *= octaves.omega;
  }
  return sum;
}

template <class L>
HWY_INLINE Vec3Of<L> dturbulence(const Vec3Of<L>& p, const Octaves& octaves) {
  double size = octaves.lambda, strength = octaves.omega;
  Vec3Of<L> sum = dnoise(p);
  for (int octave = 2; octave <= octaves.count; ++octave) {
    sum = sum + dnoise(p * L(size)) * L(strength);
    size *= octaves.lambda;
    strength *= octaves.omega;
  }
  return sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
