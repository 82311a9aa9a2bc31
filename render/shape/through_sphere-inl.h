// Where rays pass through spheres. Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_THROUGH_SPHERE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_THROUGH_SPHERE_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_THROUGH_SPHERE_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_THROUGH_SPHERE_INL_H
#endif

#include "render/shape/lane_shape-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Where rays with directions of unit length pass through a sphere.
template <class L>
struct ThroughSphere {
  MaskOf<L> met;
  L enters, leaves;
};

template <class L>
HWY_INLINE ThroughSphere<L> through_sphere(const RayOf<L>& ray, const Vec3Of<L>& center,
                                           const Same<L>& radius_squared) {
  const Vec3Of<L> to_center = center - ray.origin;
  const L distance_squared = dot(to_center, to_center);
  const L closest_approach = dot(to_center, ray.direction);
  const L half_chord_squared = radius_squared - distance_squared + closest_approach * closest_approach;
  const auto behind = (distance_squared >= radius_squared) & (closest_approach < kEpsilon);
  const L half_chord = sqrt(half_chord_squared);
  return {without(half_chord_squared > kEpsilon, behind), closest_approach - half_chord, closest_approach + half_chord};
}
template <class L>
HWY_INLINE ThroughSphere<L> through_sphere(const RayOf<L>& ray, const Vec3& center, double radius_squared) {
  return through_sphere(ray, everywhere<L>(center), radius_squared);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
