// Lengths of vectors side by side, as Imath finds that of one. Included once for each instruction set, so the guard
// switches back and forth.
#if defined(FIRSTLIGHT_RENDER_LANES_LENGTH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_LANES_LENGTH_INL_H
#undef FIRSTLIGHT_RENDER_LANES_LENGTH_INL_H
#else
#define FIRSTLIGHT_RENDER_LANES_LENGTH_INL_H
#endif

#include "render/lanes/lanes-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// That of vectors whose squares are too small for a double.
template <class L>
HWY_NOINLINE L tiny_length(const Vec3Of<L>& v) {
  const L largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
  const Vec3Of<L> shape = v / largest;
  return select(largest == 0.0, L(0.0), largest * sqrt(dot(shape, shape)));
}

/// With all its digits, however short the vector.
template <class L>
HWY_INLINE L exact_length(const Vec3Of<L>& v) {
  const L square = dot(v, v);
  const auto tiny = square < 2.0 * std::numeric_limits<double>::min();
  L length = sqrt(square);
  if (any(tiny)) length = select(tiny, tiny_length(v), length);
  return length;
}

/// Vectors of unit length; what is 0 stays so.
template <class L>
HWY_INLINE Vec3Of<L> normalized(const Vec3Of<L>& v) {
  const L length = exact_length(v);
  return select<L>(length == 0.0, v, v / length);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
