// The parts that the tests of all leaves share.
// Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_LEAF_DOUBLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_LEAF_DOUBLES_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_LEAF_DOUBLES_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_LEAF_DOUBLES_INL_H
#endif

#include "render/accel/leaf/head.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, kLanes>;

/// a . b as Vec3::dot has it.
template <class V>
HWY_INLINE V dot(const V& ax, const V& ay, const V& az, const V& bx, const V& by, const V& bz) {
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
