// Curves over a lane type. Included once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_SHAPE_PROFILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_PROFILE_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_PROFILE_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_PROFILE_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/shape/profile.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
struct PlaceOf {
  L x, y;
};

/// As ProfileSegment::at().
template <class L>
HWY_INLINE PlaceOf<L> place_on(const ProfileSegment& s, const L& w) {
  return {((s.a.x * w + s.b.x) * w + s.c.x) * w + s.d.x, ((s.a.y * w + s.b.y) * w + s.c.y) * w + s.d.y};
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
