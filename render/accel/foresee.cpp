// The light buffer's answers to what feelers meet, for several points at a time.

#include "render/accel/light_buffer.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/accel/foresee.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/accel/leaf/plane-inl.h"
#include "render/accel/leaf/sphere-inl.h"

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
HWY_INLINE auto beside(const PlaneLeaf& plane, const Vec3& light, const Points& at, const Points& way) {
  const D d;
  const V height =
      hn::Add(dot(hn::Set(d, plane.normal.x), hn::Set(d, plane.normal.y), hn::Set(d, plane.normal.z), at.x, at.y, at.z),
              hn::Set(d, plane.offset));
  const V of_light = hn::Set(d, plane.normal.dot(light) + plane.offset);
  const auto same_side = hn::Gt(hn::Mul(height, of_light), hn::Zero(d));
  if (hn::AllTrue(d, same_side)) return same_side;
  const V most = hn::Add(hn::Add(hn::Abs(way.x), hn::Abs(way.y)), hn::Abs(way.z));
  const auto in_plane =
      hn::Lt(hn::Mul(hn::Abs(height), most), hn::Mul(hn::Abs(hn::Sub(height, of_light)), hn::Set(d, 0.5 * kShadowGap)));
  return hn::Or(same_side, in_plane);
}

/// Where the ways lead through the cube.
struct Places {
  hn::VFromD<N> face, u, v;
};

HWY_INLINE Places places_of(const Points& way, std::int32_t side) {
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
  return {face, place(choose(y, z, x)), place(choose(z, x, y))};
}

/// The feelers of one vector whose end is known, a bit a lane, as in Foreseen.
struct Sight {
  unsigned clear = 0;
  unsigned blocked = 0;
};

/// Lanes whose feeler is met by its sphere, as a feeler that is traced is, to the bit.
HWY_INLINE auto blocked_by_spheres(const LightBuffer& buffer, hn::VFromD<N> sphere, const Points& at,
                                   const Points& to_light, V distance) {
  const D d;
  const hn::RebindToSigned<D> wide;
  const auto* numbers = reinterpret_cast<const double*>(buffer.spheres().data());
  static_assert(sizeof(LightBuffer::RoundBlocker) == 4 * sizeof(double));
  const auto place = hn::ShiftLeft<2>(hn::PromoteTo(wide, sphere));
  const auto number = [&](int i) HWY_ATTR { return hn::GatherIndex(d, numbers + i, place); };
  const V inverse = hn::Div(hn::Set(d, 1.0), distance);
  const SphereMeeting meeting(hn::Sub(number(0), at.x), hn::Sub(number(1), at.y), hn::Sub(number(2), at.z), number(3),
                              hn::Mul(to_light.x, inverse), hn::Mul(to_light.y, inverse), hn::Mul(to_light.z, inverse));
  const V gap = hn::Set(d, kShadowGap);
  const V least = hn::Max(gap, hn::Set(d, kNearestCrossing));
  const V most = hn::Min(hn::Sub(distance, gap), hn::Set(d, kMaxDistance));
  const auto counts = [&](V depth) HWY_ATTR { return hn::And(hn::Gt(depth, least), hn::Lt(depth, most)); };
  return hn::And(meeting.met, hn::Or(counts(meeting.enters), counts(meeting.leaves)));
}

/// Finds what the lanes in `open` meet, planes left aside.
HWY_INLINE Sight look_through(const LightBuffer& buffer, unsigned open, hn::VFromD<N> cell, const Points& at,
                              const Points& way) {
  const D d;
  const F f;
  const N n;
  static_assert(sizeof(LightBuffer::Cell) == 4 * sizeof(float));
  const auto* numbers = reinterpret_cast<const float*>(buffer.cells().data());
  const auto place = hn::ShiftLeft<2>(cell);
  const auto depth = [&](int i) HWY_ATTR { return hn::PromoteTo(d, hn::GatherIndex(f, numbers + i, place)); };
  const Points to_light{hn::Neg(way.x), hn::Neg(way.y), hn::Neg(way.z)};
  const V distance = hn::Sqrt(dot(way.x, way.y, way.z, way.x, way.y, way.z));
  const V dark = depth(2);
  // No sphere is seen from beyond kMaxDistance, so it darkens nothing there.
  const V dark_until = hn::Min(hn::Mul(dark, hn::Set(d, LightBuffer::kFarthestDark)), hn::Set(d, kMaxDistance));
  const auto in_dark = hn::And(hn::Gt(distance, dark), hn::Lt(distance, dark_until));
  Sight sight;
  sight.blocked = bits_of(d, in_dark) & open;
  sight.clear = bits_of(d, hn::Lt(distance, depth(0))) & open & ~sight.blocked;
  open &= ~(sight.clear | sight.blocked);
  if (open == 0 || buffer.spheres().empty()) return sight;
  const auto sphere = hn::GatherIndex(n, reinterpret_cast<const std::int32_t*>(numbers) + 3, place);
  const auto known = hn::Gt(sphere, hn::Set(n, -1));
  open &= bits_of(n, known);
  const unsigned met =
      bits_of(d, blocked_by_spheres(buffer, hn::IfThenElseZero(known, sphere), at, to_light, distance)) & open;
  sight.blocked |= met;
  sight.clear |= bits_of(d, hn::Lt(distance, depth(1))) & open & ~met;
  return sight;
}

/// The cells that the ways from one light to the starts lead through.
struct Ways {
  std::uint64_t wanted = 0;
  std::uint64_t open = 0;  ///< through a cell
  Column<std::int32_t> cell;
};

HWY_INLINE Points way_to(const Points& at, const Vec3& light) {
  const D d;
  return {hn::Sub(at.x, hn::Set(d, light.x)), hn::Sub(at.y, hn::Set(d, light.y)), hn::Sub(at.z, hn::Set(d, light.z))};
}

HWY_INLINE void find_cells(const LightBuffer& buffer, const FeelerStarts& starts, std::size_t number, const Vec3& light,
                           Ways& ways) {
  static_assert(LightBuffer::kTile == 8);
  const D d;
  const N n;
  const std::size_t first = number * buffer.tiles_of_cube();
  const auto* words = reinterpret_cast<const std::int32_t*>(buffer.open_tiles().data()) + first / 32;
  const auto tiles_along = hn::Set(n, static_cast<std::int32_t>(buffer.tiles_along()));
  Column<std::int32_t> tiles;
  ways.wanted = 0;
  ways.open = 0;
  for (std::size_t i = 0; i < starts.count; i += hn::Lanes(d)) {
    const Points way = way_to(load(starts.points, i), light);
    const auto lanes = std::min(starts.count - i, hn::Lanes(d));
    unsigned wanted = (1u << lanes) - 1;
    if (!starts.from_both_sides) {
      const Points normal = load(starts.normals, i);
      wanted &= ~bits_of(d, hn::Gt(dot(normal.x, normal.y, normal.z, way.x, way.y, way.z), hn::Zero(d)));
    }
    const Places places = places_of(way, buffer.cube().side());
    const auto row = hn::Add(hn::Mul(places.face, tiles_along), hn::ShiftRight<3>(places.v));
    // Columns are not cleared: what stands behind the last point need not be a number, but its tile must be one.
    const auto used = hn::Lt(hn::Iota(n, 0), hn::Set(n, static_cast<std::int32_t>(lanes)));
    const auto tile = hn::IfThenElseZero(used, hn::Add(hn::Mul(row, tiles_along), hn::ShiftRight<3>(places.u)));
    const auto word = hn::GatherIndex(n, words, hn::ShiftRight<5>(tile));
    const auto bit = hn::Shl(hn::Set(n, 1), hn::And(tile, hn::Set(n, 31)));
    hn::Store(tile, n, tiles.at.data() + i);
    hn::Store(hn::Add(hn::ShiftLeft<3>(hn::And(places.v, hn::Set(n, 7))), hn::And(places.u, hn::Set(n, 7))), n,
              ways.cell.at.data() + i);
    ways.wanted |= std::uint64_t{wanted} << i;
    ways.open |= std::uint64_t{wanted & bits_of(n, hn::Ne(hn::And(word, bit), hn::Zero(n)))} << i;
  }
  // The cells lie anywhere in memory: ask for all of them before the first is needed.
  for (std::uint64_t open = ways.open; open != 0; open &= open - 1) {
    const auto i = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(open));
    const std::uint32_t tile = buffer.tiles()[first + static_cast<std::size_t>(tiles[i])];
    ways.cell[i] += static_cast<std::int32_t>((tile - 1) * LightBuffer::kCellsOfTile);
    __builtin_prefetch(&buffer.cells()[static_cast<std::size_t>(ways.cell[i])]);
  }
}

/// Bits of the lanes whose feelers may meet none of the planes.
HWY_INLINE unsigned beside_all(std::span<const PlaneLeaf> planes, unsigned lanes, const Vec3& light, const Points& at,
                               const Points& way) {
  for (const PlaneLeaf& plane : planes) {
    if (lanes == 0) break;
    if ((plane.head.hidden_from & kHiddenFromShadow) == 0) lanes &= bits_of(D(), beside(plane, light, at, way));
  }
  return lanes;
}

HWY_INLINE Foreseen look_along(const Leaves& leaves, const LightBuffer& buffer, const FeelerStarts& starts,
                               std::size_t number, const Vec3& light, const Ways& ways) {
  const D d;
  const N n;
  const LightBuffer::Around& around = buffer.around(number);
  Foreseen found;
  for (std::size_t i = 0; i < starts.count; i += hn::Lanes(d)) {
    constexpr unsigned kAll = (1u << hn::MaxLanes(D())) - 1;
    const unsigned open = static_cast<unsigned>(ways.open >> i) & kAll;
    Sight sight;
    sight.clear = static_cast<unsigned>((ways.wanted & ~ways.open) >> i) & kAll;
    if ((open | sight.clear) == 0) continue;
    const Points at = load(starts.points, i);
    const Points way = way_to(at, light);
    if (open != 0) {
      const Sight seen = look_through(buffer, open, hn::Load(n, ways.cell.at.data() + i), at, way);
      sight.clear |= seen.clear;
      sight.blocked = seen.blocked;
    }
    sight.clear = beside_all(leaves.planes, sight.clear, light, at, way);
    sight.clear = beside_all(around.walls, sight.clear, light, at, way);
    if (around.limit < FloatBox::kInfinity) {
      const V square = dot(way.x, way.y, way.z, way.x, way.y, way.z);
      sight.clear &= bits_of(d, hn::Lt(square, hn::Set(d, around.limit * around.limit)));
    }
    found.clear |= std::uint64_t{sight.clear} << i;
    found.blocked |= std::uint64_t{sight.blocked} << i;
  }
  return found;
}

void find_foreseen_of(const Leaves& leaves, const LightBuffer& buffer, const FeelerStarts& starts, std::size_t first,
                      std::span<const Light> lights, std::span<Foreseen> foreseen) {
  constexpr std::size_t kTogether = 4;
  std::array<Ways, kTogether> ways;
  for (std::size_t l = 0; l < lights.size(); l += kTogether) {
    const std::size_t count = std::min(kTogether, lights.size() - l);
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_one_point(lights[l + k])) continue;
      find_cells(buffer, starts, first + l + k, lights[l + k].position, ways[k]);
    }
    for (std::size_t k = 0; k < count; ++k) {
      foreseen[l + k] = is_one_point(lights[l + k])
                            ? look_along(leaves, buffer, starts, first + l + k, lights[l + k].position, ways[k])
                            : Foreseen();
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_foreseen_of);

void find_foreseen(const Leaves& leaves, const LightBuffer& buffer, const FeelerStarts& starts, std::size_t first,
                   std::span<const Light> lights, std::span<Foreseen> foreseen) {
  HWY_DYNAMIC_DISPATCH(find_foreseen_of)(leaves, buffer, starts, first, lights, foreseen);
}

}  // namespace firstlight::render
#endif
