// Curves of the x-y plane as surfaces: drawn out along z, or turned about the y axis. The last three parameters are the
// same for all of them: whether to turn, the offset from the axis, and the angle of the curve.
// Source   The formulas as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/internal_plane.cpp"
#include <hwy/foreach_target.h>

#include "render/function/internal-inl.h"
#include "render/lanes/math.h"

#include <numbers>

#ifndef FIRSTLIGHT_INTERNAL_PLANE
#define FIRSTLIGHT_INTERNAL_PLANE(ROW) \
  ROW(0, algbr_cyl1, 8)                \
  ROW(1, algbr_cyl2, 8)                \
  ROW(2, algbr_cyl3, 8)                \
  ROW(3, algbr_cyl4, 8)                \
  ROW(15, devils_curve_2d, 9)          \
  ROW(21, folium_surface_2d, 9)        \
  ROW(34, kampyle_of_eudoxus_2d, 9)    \
  ROW(39, lemniscate_of_gerono_2d, 9)  \
  ROW(50, piriform_2d, 10)             \
  ROW(67, strophoid_2d, 10)            \
  ROW(75, witch_of_agnesi_2d, 9)
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// A point of the plane, after the turn about the axis if there is one.
template <class L>
struct Place {
  L x, y, x2, y2;
};
/// `turn`: the three parameters of the turn.
template <class L>
HWY_INLINE Place<L> place_of(const Vec3Of<L>& p, const double* turn) {
  if (!(turn[0] > 0)) return {p.x, p.y, p.x * p.x, p.y * p.y};
  const L from_axis = sqrt(p.x * p.x + p.z * p.z) - turn[1];
  const double angle = turn[2] * (std::numbers::pi / 180.0);
  L x = from_axis, y = p.y;
  if (angle != 0) {
    x = from_axis * steady::cosine(angle) - p.y * steady::sine(angle);
    y = from_axis * steady::sine(angle) + p.y * steady::cosine(angle);
  }
  return {x, y, x * x, y * y};
}
template <class L>
HWY_INLINE L held(const double* own, const L& value, double limit = 10.0) {
  return min(L(limit), max(own[0] * value, L(-limit)));
}

template <class L>
HWY_INLINE L algbr_cyl1(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 2);
  const L x = abs(at.x);
  return -held<L>(own, -(at.x2 * x - at.x2 + at.y2), own[1]);
}

template <class L>
HWY_INLINE L algbr_cyl2(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 2);
  return held<L>(own, -(2 * at.x2 * at.x2 - 3 * at.x2 * at.y + at.y2 - 2 * at.y2 * at.y + at.y2 * at.y2), own[1]);
}

template <class L>
HWY_INLINE L algbr_cyl3(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 2);
  return held<L>(own, -(at.x2 * at.x2 + at.x2 * at.y2 - 2 * at.x2 * at.y - at.x * at.y2 + at.y2), own[1]);
}

template <class L>
HWY_INLINE L algbr_cyl4(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 2);
  return held<L>(own, -(at.x2 * at.x2 + at.y2 * at.y2 + 2 * at.x2 * at.y2 + 3 * at.x2 * at.y - at.y2 * at.y), own[1]);
}

template <class L>
HWY_INLINE L devils_curve_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 3);
  return held<L>(own, -(at.x2 * (at.x2 - own[1] * own[1]) - at.y2 * (at.y2 - own[2] * own[2])));
}

template <class L>
HWY_INLINE L folium_surface_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 3);
  return held<L>(own, -(at.y2 * (1 + (own[2] - 4 * own[1]) * at.x) + at.x2 * (1 + own[2])));
}

// POV-Ray multiplies both parameters where a square of the first is meant.
template <class L>
HWY_INLINE L kampyle_of_eudoxus_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 3);
  const double closeness = own[2] * own[2];
  return held<L>(own, -(at.y2 - closeness * at.x2 * at.x2 + closeness * own[1] * own[2] * at.x2));
}

template <class L>
HWY_INLINE L lemniscate_of_gerono_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 3);
  const double width = own[2] * own[2];
  return held<L>(own, -(at.y2 - width * own[1] * own[1] * at.x2 + width * at.x2 * at.x2));
}

template <class L>
HWY_INLINE L piriform_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 4);
  return held<L>(own,
                 -(at.y * at.y - own[1] * own[3] * own[3] * at.x2 * at.x - own[2] * own[3] * own[3] * at.x2 * at.x2));
}

template <class L>
HWY_INLINE L strophoid_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 4);
  const double size = own[3] * own[3];
  return held<L>(own, -((own[2] - at.x) * at.y2 - size * own[1] * at.x2 - size * at.x2 * at.x));
}

template <class L>
HWY_INLINE L witch_of_agnesi_2d(const Vec3Of<L>& p, const double* own, int) {
  const Place<L> at = place_of(p, own + 3);
  return held<L>(own, -(own[1] * own[1] * at.y + at.x2 * at.y - own[2]));
}

FIRSTLIGHT_INTERNAL_KERNEL(internal_plane, FIRSTLIGHT_INTERNAL_PLANE)

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

FIRSTLIGHT_INTERNAL_MEMBERS(internal_plane, FIRSTLIGHT_INTERNAL_PLANE)

}  // namespace firstlight::render
#endif
