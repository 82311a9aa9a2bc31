// Which feelers certainly meet nothing, several points at a time.

#include "render/accel/clear_directions.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/accel/clear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/accel/box_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

using D = hn::CappedTag<double, 8>;
using F = hn::Rebind<float, D>;
using N = hn::RebindToSigned<F>;
using V = hn::VFromD<D>;

/// A vector of points, or of the ways from the light to them.
struct Points {
  V x, y, z;
};

HWY_INLINE Points load(const Columns3<double>& points, std::size_t i) {
  const D d;
  return {hn::Load(d, points.of[0].at.data() + i), hn::Load(d, points.of[1].at.data() + i),
          hn::Load(d, points.of[2].at.data() + i)};
}

/// Not set where a feeler may meet the plane, further from its point than what feelers ignore. Points in the plane
/// itself count as beside it: with h their heights above it, a feeler of length s meets it at the depth
/// s |h| / |h - h of the light|. The sum of the way's coordinates is not less than s. Half of the gap is for rounding.
HWY_INLINE auto beside(const PlaneLeaf& plane, const Vec3& light, const Points& at, const Points& way, double gap) {
  const D d;
  const V height =
      hn::Add(hn::Add(hn::Add(hn::Mul(hn::Set(d, plane.normal.x), at.x), hn::Mul(hn::Set(d, plane.normal.y), at.y)),
                      hn::Mul(hn::Set(d, plane.normal.z), at.z)),
              hn::Set(d, plane.offset));
  const V of_light = hn::Set(d, plane.normal.dot(light) + plane.offset);
  const V most = hn::Add(hn::Add(hn::Abs(way.x), hn::Abs(way.y)), hn::Abs(way.z));
  const auto same_side = hn::Gt(hn::Mul(height, of_light), hn::Zero(d));
  const auto in_plane =
      hn::Lt(hn::Mul(hn::Abs(height), most), hn::Mul(hn::Abs(hn::Sub(height, of_light)), hn::Set(d, 0.5 * gap)));
  return hn::Or(same_side, in_plane);
}

/// Numbers of the cells that the ways lead through, as ClearDirections has them.
HWY_INLINE hn::VFromD<N> cells_of(const Points& way, std::int32_t side) {
  const F f;
  const N n;
  const auto x = hn::DemoteTo(f, way.x);
  const auto y = hn::DemoteTo(f, way.y);
  const auto z = hn::DemoteTo(f, way.z);
  const auto along_x = hn::And(hn::Ge(hn::Abs(x), hn::Abs(y)), hn::Ge(hn::Abs(x), hn::Abs(z)));
  const auto along_y = hn::Ge(hn::Abs(y), hn::Abs(z));
  const auto choose = [&](auto of_x, auto of_y, auto of_z)
                          HWY_ATTR { return hn::IfThenElse(along_x, of_x, hn::IfThenElse(along_y, of_y, of_z)); };
  const auto depth = choose(x, y, z);
  const auto half = hn::Set(f, 0.5f * static_cast<float>(side));
  const auto most = hn::Set(f, static_cast<float>(side - 1));
  const auto scale = hn::Div(half, hn::Max(hn::Abs(depth), hn::Set(f, 1e-30f)));
  const auto place = [&](hn::VFromD<F> along) HWY_ATTR {
    return hn::ConvertTo(n, hn::Min(hn::Max(hn::Add(hn::Mul(along, scale), half), hn::Zero(f)), most));
  };
  const auto backwards = hn::IfThenElseZero(hn::Lt(depth, hn::Zero(f)), hn::Set(f, 1.0f));
  const auto face = hn::ConvertTo(n, hn::Add(choose(hn::Zero(f), hn::Set(f, 2.0f), hn::Set(f, 4.0f)), backwards));
  const auto rows = hn::Set(n, side);
  const auto row = hn::Add(hn::Mul(face, rows), place(choose(z, x, y)));
  return hn::Add(hn::Mul(row, rows), place(choose(y, z, x)));
}

void find_clear_of(const Leaves& leaves, const ClearDirections& directions, const Columns3<double>& points,
                   std::size_t count, std::size_t first, std::span<const Light> lights, double gap,
                   std::uint64_t* clear) {
  const D d;
  const N n;
  const auto* words = reinterpret_cast<const std::int32_t*>(directions.words().data());
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Vec3 light = lights[l].position;
    const auto cube = hn::Set(n, static_cast<std::int32_t>((first + l) * directions.cells_of_cube()));
    clear[l] = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      const Points at = load(points, i);
      const Points way{hn::Sub(at.x, hn::Set(d, light.x)), hn::Sub(at.y, hn::Set(d, light.y)),
                       hn::Sub(at.z, hn::Set(d, light.z))};
      // Columns are not cleared: what stands behind the last point need not be a number, but its cell must be one.
      const auto used =
          hn::Lt(hn::Iota(n, 0), hn::Set(n, static_cast<std::int32_t>(std::min(count - i, hn::Lanes(d)))));
      const auto cell = hn::Add(cube, hn::IfThenElseZero(used, cells_of(way, directions.side())));
      const auto word = hn::GatherIndex(n, words, hn::ShiftRight<5>(cell));
      const auto bit = hn::Shl(hn::Set(n, 1), hn::And(cell, hn::Set(n, 31)));
      const auto is_empty = hn::And(used, hn::Eq(hn::And(word, bit), hn::Zero(n)));
      unsigned bits = bits_of(n, is_empty);
      for (const PlaneLeaf& plane : leaves.planes) {
        if ((plane.head.hidden_from & kHiddenFromShadow) == 0) bits &= bits_of(d, beside(plane, light, at, way, gap));
      }
      clear[l] |= std::uint64_t{bits} << i;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_clear_of);

void find_clear(const Leaves& leaves, const ClearDirections& directions, const Columns3<double>& points,
                std::size_t count, std::size_t first, std::span<const Light> lights, double gap, std::uint64_t* clear) {
  HWY_DYNAMIC_DISPATCH(find_clear_of)(leaves, directions, points, count, first, lights, gap, clear);
}

}  // namespace firstlight::render
#endif
