#include "render/texture/warp.h"

#include "render/math/lattice_random.h"
#include "render/math/single.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/warp.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"
#include "render/math/noise-inl.h"
#include "render/math/transform-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Patterns are evaluated no farther from their origin than this. [POV-Ray 3.7]
constexpr double kFarthest = 1e17;
constexpr double kWholeTurn = 2.0 * kPiHigh;

template <class L>
HWY_INLINE L& component(Vec3Of<L>& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

template <class L>
HWY_INLINE L to_single(const L& x) {
  return one_by_one(L::first(L::kCount), x, in_single);
}

// The point before a warp for one behind it. [POV-Ray 3.7]
template <class L>
HWY_INLINE Vec3Of<L> unwarped(const Transform& transform, const Vec3Of<L>& p) {
  return transform.is_identity() ? p : point_times(p, transform.inverse_matrix());
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const Turbulence& turbulence, const Vec3Of<L>& p) {
  return p + dturbulence(p, octaves_of(turbulence)) * everywhere<L>(turbulence.amount);
}

/// Every other block is mirrored along the axes that flip; blocks are counted in single precision.
template <class L>
HWY_INLINE Vec3Of<L> unwarped(const RepeatWarp& repeat, const Vec3Of<L>& p) {
  const int axis = repeat.axis;
  const double width = in_single(repeat.width);
  Vec3Of<L> there = p;
  L& along = component(there, axis);
  const L block = to_single(floor(along / width));
  along = along - to_single(block * width);
  const L pairs = 0.5 * block;
  Vec3Of<L> mirrored = there * everywhere<L>(repeat.flip);
  if (repeat.flip[axis] < 0.0) component(mirrored, axis) = width + component(mirrored, axis);
  there = select(pairs - trunc(pairs) != 0.0, mirrored, there);
  return there + everywhere<L>(repeat.offset) * block;
}

/// The centre of a repeated hole in the block that a point lies in.
template <class L>
HWY_INLINE Vec3Of<L> center_near(const BlackHoleWarp& hole, Vec3Of<L> p) {
  constexpr double kNoBlock = 1e-10;
  Vec3Of<L> block = {L(0.0), L(0.0), L(0.0)};
  for (int axis = 0; axis < 3; ++axis) {
    const double size = (*hole.repeat)[axis];
    if (size >= kNoBlock) component(block, axis) = floor(component(p, axis) / size);
  }
  Vec3Of<L> center = everywhere<L>(hole.center);
  if (hole.turbulence) {
    double x[L::kCount], y[L::kCount], z[L::kCount];
    block.x.store(x);
    block.y.store(y);
    block.z.store(z);
    for (std::size_t i = 0; i < L::kCount; ++i) {
      const unsigned hash = cell_hash(x[i], y[i], z[i]);
      x[i] = table_random(hash);
      y[i] = table_random(hash + 1);
      z[i] = table_random(hash + 2);
    }
    center = center + Vec3Of<L>{L::load(x), L::load(y), L::load(z)} * everywhere<L>(*hole.turbulence);
  }
  return center + everywhere<L>(*hole.repeat) * block;
}

/// Points are moved from the hole's centre, the further the nearer they are, so that the pattern seems drawn in.
template <class L>
HWY_INLINE Vec3Of<L> unwarped(const BlackHoleWarp& hole, const Vec3Of<L>& p) {
  if (hole.type != 0) return p;
  const Vec3Of<L> way = p - (hole.repeat ? center_near(hole, p) : everywhere<L>(hole.center));
  const L distance = length(way);
  const MaskOf<L> is_within = distance < hole.radius;
  const L nearness = (hole.radius - select(is_within, distance, L(0.0))) / hole.radius;
  const L strength = min(power(nearness, L(hole.falloff)) * hole.strength, 1.0);
  return select(is_within, p + way * (hole.inverted ? -strength : strength), p);
}

/// A flat picture stands across z. Turns it across `direction`, the way POV-Ray does for the axes; other directions make
/// mixtures.
template <class L>
HWY_INLINE Vec3Of<L> turned(const Vec3Of<L>& p, const Vec3& direction) {
  if (direction == Vec3(0.0, 0.0, 1.0)) return p;
  return {direction.x * p.z + direction.y * p.x + direction.z * p.x,
          direction.x * p.y + direction.y * -p.z + direction.z * p.y,
          direction.x * -p.x + direction.y * p.y + direction.z * p.z};
}

/// Part of a turn from the x axis towards z.
template <class L>
HWY_INLINE L turn_about_y(const L& x, const L& z, const L& length) {
  const L angle = arc_cosine(x / length);
  const L turn = select(z < 0.0, kWholeTurn - angle, angle) / kWholeTurn;
  return select(z == 0.0, select(x > 0.0, L(0.0), L(0.5)), turn);
}

/// The factor that stretches angles at a distance.
template <class L>
HWY_INLINE L stretch(const L& distance, double exponent) {
  if (exponent == 0.0) return 1.0;
  return exponent == 1.0 ? distance : power(distance, L(exponent));
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const CylindricalWarp& warp, const Vec3Of<L>& p) {
  const L distance = sqrt(p.x * p.x + p.z * p.z);
  const L turn = turn_about_y(p.x, p.z, distance) * stretch(distance, warp.distance_exponent);
  return select(distance == 0.0, p, turned<L>({turn, p.y, distance}, warp.orientation));
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const SphericalWarp& warp, const Vec3Of<L>& p) {
  const L distance = length(p);
  const Vec3Of<L> unit = p / distance;
  const L from_axis = sqrt(unit.x * unit.x + unit.z * unit.z);
  const L turn = select(from_axis == 0.0, L(0.0), turn_about_y(unit.x, unit.z, from_axis));
  const L up = 0.5 + arc_sine(unit.y) / kPiHigh;
  const L factor = stretch(distance, warp.distance_exponent);
  return select(distance == 0.0, p, turned<L>({turn * factor, up * factor, distance}, warp.orientation));
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const ToroidalWarp& warp, const Vec3Of<L>& p) {
  const L from_axis = sqrt(p.x * p.x + p.z * p.z);
  const L x = from_axis - warp.major_radius;
  const L distance = sqrt(x * x + p.y * p.y);
  L around = arc_cosine(-x / distance);
  around = select(p.y > 0.0, kWholeTurn - around, around);
  const L factor = stretch(distance, warp.distance_exponent);
  const L turn = turn_about_y(p.x, p.z, from_axis) * factor;
  return select(from_axis == 0.0, p, turned<L>({turn, around / kWholeTurn * factor, distance}, warp.orientation));
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const PlanarWarp& warp, const Vec3Of<L>& p) {
  return turned<L>({p.x, p.y, L(warp.offset)}, warp.orientation);
}

/// A place on a side of a cube, by how far it is along the net's two axes and how far away.
template <class L>
HWY_INLINE L across_net(const L& place) {
  return 0.25 * (place + 1.0) / 2.0;
}
template <class L>
HWY_INLINE L up_net(const L& place) {
  return 1.0 / 3.0 * (place + 1.0) / 2.0;
}
/// The six sides of a cube as they lie in a picture of its net, four wide and three high; z is the distance.
template <class L>
HWY_INLINE Vec3Of<L> unwarped(const CubicWarp&, const Vec3Of<L>& p) {
  constexpr double kMiddle = 1.0 / 3.0;
  const L x = abs(p.x), y = abs(p.y), z = abs(p.z);
  // From the side that is asked last to the first: each takes what is its own from those behind it.
  Vec3Of<L> there = {1.0 - across_net(p.x / -p.z), kMiddle + up_net(p.y / -p.z), -p.z};
  there = select((p.y < 0.0) & (y >= x) & (y >= z), Vec3Of<L>{0.25 + across_net(p.x / y), up_net(p.z / y), y}, there);
  there =
      select((p.x < 0.0) & (x >= y) & (x >= z), Vec3Of<L>{across_net(p.z / x), kMiddle + up_net(p.y / x), x}, there);
  there = select((p.z >= 0.0) & (p.z >= x) & (p.z >= y),
                 Vec3Of<L>{0.25 + across_net(p.x / p.z), kMiddle + up_net(p.y / p.z), p.z}, there);
  there = select((p.y >= 0.0) & (p.y >= x) & (p.y >= z),
                 Vec3Of<L>{0.25 + across_net(p.x / p.y), 1.0 - up_net(p.z / p.y), p.y}, there);
  return select((p.x >= 0.0) & (p.x >= y) & (p.x >= z),
                Vec3Of<L>{0.75 - across_net(p.z / p.x), kMiddle + up_net(p.y / p.x), p.x}, there);
}

template <class L>
HWY_INLINE Vec3Of<L> unwarped(const Warp& warp, const Vec3Of<L>& p) {
  switch (warp.index()) {
    case 0:
      return unwarped(std::get<Transform>(warp), p);
    case 1:
      return unwarped(std::get<Turbulence>(warp), p);
    case 2:
      return unwarped(std::get<RepeatWarp>(warp), p);
    case 3:
      return unwarped(std::get<BlackHoleWarp>(warp), p);
    case 4:
      return unwarped(std::get<CylindricalWarp>(warp), p);
    case 5:
      return unwarped(std::get<SphericalWarp>(warp), p);
    case 6:
      return unwarped(std::get<ToroidalWarp>(warp), p);
    case 7:
      return unwarped(std::get<PlanarWarp>(warp), p);
    default:
      return unwarped(std::get<CubicWarp>(warp), p);
  }
}

void unwarp_block(const Warps& warps, bool moves, Columns3<double>& points, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    Vec3Of<Lanes> p = load3<Lanes>(points, i);
    for (auto step = warps.steps.rbegin(); step != warps.steps.rend(); ++step) p = unwarped(*step, p);
    if (warps.turbulence && moves) p = unwarped(*warps.turbulence, p);
    p = {clamp(p.x, -kFarthest, kFarthest), clamp(p.y, -kFarthest, kFarthest), clamp(p.z, -kFarthest, kFarthest)};
    store3(p, points, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(unwarp_block);

}  // namespace

Octaves octaves_of(const Turbulence& turbulence) {
  return {turbulence.octaves, static_cast<float>(turbulence.lambda), static_cast<float>(turbulence.omega)};
}

void Warps::transform(const Transform& next) {
  if (next.is_identity()) return;
  if (!steps.empty()) {
    if (auto* last = std::get_if<Transform>(&steps.back())) {
      *last = last->then(next);
      return;
    }
  }
  steps.emplace_back(next);
}

void Warps::to_pattern(Columns3<double>& points, std::size_t count, bool moves) const {
  HWY_DYNAMIC_DISPATCH(unwarp_block)(*this, moves, points, count);
}

Vec3 Warps::to_pattern(const Vec3& point, bool moves) const {
  Columns3<double> points;
  points.set(0, point);
  to_pattern(points, 1, moves);
  return points.vector(0);
}

}  // namespace firstlight::render
#endif
