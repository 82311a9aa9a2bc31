// How formulas over a lane type are evaluated for blocks of points. Included once for each instruction set, so the guard
// switches back and forth.
#if defined(FIRSTLIGHT_RENDER_TEXTURE_LANE_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_TEXTURE_LANE_FIELD_INL_H
#undef FIRSTLIGHT_RENDER_TEXTURE_LANE_FIELD_INL_H
#else
#define FIRSTLIGHT_RENDER_TEXTURE_LANE_FIELD_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/math/columns.h"
#include "render/texture/pattern.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// values[i] = value(formula, point i).
template <class Formula>
HWY_NOINLINE void values_at(const Formula& formula, const Columns3<double>& at, std::size_t count,
                            Column<double>& values) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    store(value(formula, load3<Lanes>(at, i)), values, i);
  }
}

/// Adds tilt(formula, point i, tilting) to normal i.
template <class Formula>
HWY_NOINLINE void tilt_at(const Formula& formula, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
                          Columns3<double>& normals) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    store3(load3<Lanes>(normals, i) + tilt(formula, load3<Lanes>(at, i), tilting), normals, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
