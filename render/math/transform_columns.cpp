#include "render/math/transform_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/math/transform_columns.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/length-inl.h"
#include "render/math/transform-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// out[i] = change(vectors[i]) for i in [first, end).
template <class Change>
HWY_INLINE void change_each(const Columns3<double>& vectors, std::size_t first, std::size_t end, Columns3<double>& out,
                            const Change& change) {
  for (std::size_t i = first - first % Lanes::kCount; i < end; i += Lanes::kCount) {
    const auto after = change(load3<Lanes>(vectors, i));
    LanesMask meant = Lanes::first(end - i);
    if (i < first) meant = without(meant, Lanes::first(first - i));
    store3(select<Lanes>(meant, after, load3<Lanes>(out, i)), out, i);
  }
}

void find_inverse_points(const Transform& transform, const Columns3<double>& points, std::size_t first, std::size_t end,
                         Columns3<double>& out) {
  const Mat4& back = transform.inverse_matrix();
  if (transform.is_identity()) {
    change_each(points, first, end, out, [](const Vec3Of<Lanes>& p) HWY_ATTR { return p; });
  } else {
    change_each(points, first, end, out, [&](const Vec3Of<Lanes>& p) HWY_ATTR { return point_times(p, back); });
  }
}

void place_each_normal(const Transform& transform, bool inverted, std::size_t first, std::size_t end,
                       Columns3<double>& normals) {
  const Mat4& back = transform.inverse_matrix();
  const bool placed = !transform.is_identity();
  change_each(normals, first, end, normals, [&](const Vec3Of<Lanes>& own) HWY_ATTR {
    const auto n = normalized(placed ? normal_times(own, back) : own);
    return inverted ? -n : n;
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(find_inverse_points);
HWY_EXPORT(place_each_normal);

}  // namespace

void inverse_points(const Transform& transform, const Columns3<double>& points, std::size_t first, std::size_t end,
                    Columns3<double>& out) {
  HWY_DYNAMIC_DISPATCH(find_inverse_points)(transform, points, first, end, out);
}

void place_normals(const Transform& transform, bool inverted, std::size_t first, std::size_t end,
                   Columns3<double>& normals) {
  HWY_DYNAMIC_DISPATCH(place_each_normal)(transform, inverted, first, end, normals);
}

}  // namespace firstlight::render
#endif
