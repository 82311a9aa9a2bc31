// How formulas of built-in functions over a lane type are asked for many points, and for one. Included once for each
// instruction set, so the guard switches back and forth.
//
//     formula(point, own, generator)   `own` are its further parameters, the same at all points; the scene's noise
//                                      generator
#if defined(FIRSTLIGHT_RENDER_FUNCTION_INTERNAL_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_FUNCTION_INTERNAL_INL_H
#undef FIRSTLIGHT_RENDER_FUNCTION_INTERNAL_INL_H
#else
#define FIRSTLIGHT_RENDER_FUNCTION_INTERNAL_INL_H
#endif

#include "render/function/internal.h"
#include "render/lanes/lanes-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Whether all numbers have the bits of the first.
HWY_INLINE bool are_the_same(const double* numbers, std::size_t count) {
  const auto first = std::bit_cast<std::uint64_t>(numbers[0]);
  std::uint64_t differing = 0;
  for (std::size_t i = 1; i < count; ++i) differing |= std::bit_cast<std::uint64_t>(numbers[i]) ^ first;
  return differing == 0;
}

template <auto kOneFormula>
double one_of(const double* p, int generator) {
  return kOneFormula(Vec3Of<One>{p[0], p[1], p[2]}, p + 3, generator).v;
}

/// Where parameters of its own differ from point to point, one point after the other.
template <auto kFormula, auto kOneFormula>
HWY_NOINLINE void rows_of(std::size_t parameters, const double* const* arguments, double* result, std::size_t count,
                          int generator) {
  double point[Function::kMostParameters];
  bool is_uniform = true;
  for (std::size_t p = 3; p < parameters && is_uniform; ++p) {
    point[p] = arguments[p][0];
    is_uniform = are_the_same(arguments[p], count);
  }
  if (!is_uniform) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t p = 0; p < parameters; ++p) point[p] = arguments[p][i];
      result[i] = one_of<kOneFormula>(point, generator);
    }
    return;
  }
  const auto at = [&](const double* x, const double* y, const double* z) HWY_ATTR {
    return kFormula(Vec3Of<Lanes>{Lanes::load(x), Lanes::load(y), Lanes::load(z)}, point + 3, generator);
  };
  std::size_t i = 0;
  for (; i + Lanes::kCount <= count; i += Lanes::kCount) {
    at(arguments[0] + i, arguments[1] + i, arguments[2] + i).store(result + i);
  }
  if (i == count) return;
  double rest[4][Lanes::kCount] = {};
  for (std::size_t axis = 0; axis < 3; ++axis) std::copy_n(arguments[axis] + i, count - i, rest[axis]);
  at(rest[0], rest[1], rest[2]).store(rest[3]);
  std::copy_n(rest[3], count - i, result + i);
}

template <class L>
HWY_INLINE L length_of(const L& a, const L& b) {
  return sqrt(a * a + b * b);
}

/// A remainder by which everybody divides alike.
template <class L>
HWY_INLINE L remainder(const L& a, double period) {
  double numbers[L::kCount];
  a.store(numbers);
  for (double& number : numbers) number = std::fmod(number, period);
  return L::load(numbers);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

// A pair of macros offers a family of formulas, a macro that calls ROW(number, formula, parameters) for each. The first
// stands in HWY_NAMESPACE, the second behind HWY_ONCE.

#define FIRSTLIGHT_INTERNAL_CASE(number, formula, parameters) \
  case number:                                                \
    return rows_of<formula<Lanes>, formula<One>>(parameters, arguments, result, count, generator);
#define FIRSTLIGHT_INTERNAL_KERNEL(family, Rows)                                                            \
  void family##_rows(std::size_t number, const double* const* arguments, double* result, std::size_t count, \
                     int generator) {                                                                       \
    switch (number) { Rows(FIRSTLIGHT_INTERNAL_CASE) default : return; }                                    \
  }
#define FIRSTLIGHT_INTERNAL_ROW(number, formula, parameters) \
  {number, parameters, HWY_NAMESPACE::one_of<HWY_NAMESPACE::formula<One>>},
#define FIRSTLIGHT_INTERNAL_MEMBERS(family, Rows)                                                                      \
  HWY_EXPORT(family##_rows);                                                                                           \
  InternalFamily family() {                                                                                            \
    static constexpr InternalFunction kRows[] = {Rows(FIRSTLIGHT_INTERNAL_ROW)};                                       \
    return {kRows,                                                                                                     \
            [](std::size_t number, const double* const* arguments, double* result, std::size_t count, int generator) { \
              HWY_DYNAMIC_DISPATCH(family##_rows)(number, arguments, result, count, generator);                        \
            }};                                                                                                        \
  }

#endif
