#include "render/surface/normal_space.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/surface/normal_space.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/length-inl.h"

#include <variant>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Sums as in Transform::normal(), of which `inverse` is the inverse matrix.
HWY_INLINE Vec3Of<Lanes> normal_times(const Vec3Of<Lanes>& n, const Mat4& inverse) {
  return {n.x * inverse[0][0] + n.y * inverse[0][1] + n.z * inverse[0][2],
          n.x * inverse[1][0] + n.y * inverse[1][1] + n.z * inverse[1][2],
          n.x * inverse[2][0] + n.y * inverse[2][1] + n.z * inverse[2][2]};
}

HWY_INLINE Vec3Of<Lanes> moved(const Vec3Of<Lanes>& n, const Transform& transform) {
  return transform.is_identity() ? n : normal_times(n, transform.inverse_matrix());
}
HWY_INLINE Vec3Of<Lanes> moved_back(const Vec3Of<Lanes>& n, const Transform& transform) {
  return transform.is_identity() ? n : normal_times(n, transform.matrix());
}

/// normals = change(normals), so many at once.
template <class Change>
HWY_INLINE void change_all(std::size_t count, Columns3<double>& normals, const Change& change) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) store3(change(load3<Lanes>(normals, i)), normals, i);
}

void go_into(const NormalSpace& space, std::size_t count, Columns3<double>& normals) {
  change_all(count, normals, [&](Vec3Of<Lanes> n) HWY_ATTR {
    if (!space.keeps_length) n = normalized(n);
    if (space.placement != nullptr) n = moved(n, *space.placement);
    const std::vector<Warp>& steps = space.warps->steps;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
      if (const auto* transform = std::get_if<Transform>(&*step)) n = moved_back(n, *transform);
    }
    return space.keeps_length ? n : normalized(n);
  });
}

void go_out_of(const NormalSpace& space, std::size_t count, Columns3<double>& normals) {
  change_all(count, normals, [&](Vec3Of<Lanes> n) HWY_ATTR {
    if (!space.keeps_length) n = normalized(n);
    for (const Warp& step : space.warps->steps) {
      if (const auto* transform = std::get_if<Transform>(&step)) n = moved(n, *transform);
    }
    if (space.placement != nullptr) n = moved_back(n, *space.placement);
    return space.keeps_length ? n : normalized(n);
  });
}

void normalize(std::size_t count, Columns3<double>& normals) {
  change_all(count, normals, [](const Vec3Of<Lanes>& n) HWY_ATTR { return normalized(n); });
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(go_into);
HWY_EXPORT(go_out_of);
HWY_EXPORT(normalize);

void NormalSpace::into(std::size_t count, Columns3<double>& normals) const {
  HWY_DYNAMIC_DISPATCH(go_into)(*this, count, normals);
}

void NormalSpace::out_of(std::size_t count, Columns3<double>& normals) const {
  HWY_DYNAMIC_DISPATCH(go_out_of)(*this, count, normals);
}

void normalize_all(std::size_t count, Columns3<double>& normals) { HWY_DYNAMIC_DISPATCH(normalize)(count, normals); }

}  // namespace firstlight::render
#endif
