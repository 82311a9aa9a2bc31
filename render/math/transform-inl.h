// Points, directions and normals side by side, times the matrices of a Transform; sums are made as there. Included once for
// each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_MATH_TRANSFORM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_MATH_TRANSFORM_INL_H
#undef FIRSTLIGHT_RENDER_MATH_TRANSFORM_INL_H
#else
#define FIRSTLIGHT_RENDER_MATH_TRANSFORM_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE Vec3Of<L> direction_times(const Vec3Of<L>& v, const Mat4& m) {
  return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
          v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
}
template <class L>
HWY_INLINE Vec3Of<L> point_times(const Vec3Of<L>& p, const Mat4& m) {
  return {p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
          p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
          p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]};
}
/// `inverse` is that of the matrix that normals go with.
template <class L>
HWY_INLINE Vec3Of<L> normal_times(const Vec3Of<L>& n, const Mat4& inverse) {
  return {n.x * inverse[0][0] + n.y * inverse[0][1] + n.z * inverse[0][2],
          n.x * inverse[1][0] + n.y * inverse[1][1] + n.z * inverse[1][2],
          n.x * inverse[2][0] + n.y * inverse[2][1] + n.z * inverse[2][2]};
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
