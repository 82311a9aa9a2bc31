// How formulas of shapes over a lane type meet blocks of rays, and single ones. Included once for each instruction set,
// so the guard switches back and forth.
//
// A shape's numbers are a struct with `kSlots`, the most crossings that a ray may have. Its formulas are functions
// beside it:
//
//     meet(shape, ray, met)            calls met(k, depth, mask) or met(k, depth, mask, face), with k from 0 to
//                                      kSlots - 1 each at most once and in this order, for the k-th crossing, which
//                                      those rays have that are in the mask
//     inside(shape, point, inverted)   the mask of the points that are in the shape, or in its complement
#if defined(FIRSTLIGHT_RENDER_SHAPE_LANE_SHAPE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_SHAPE_LANE_SHAPE_INL_H
#undef FIRSTLIGHT_RENDER_SHAPE_LANE_SHAPE_INL_H
#else
#define FIRSTLIGHT_RENDER_SHAPE_LANE_SHAPE_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/lanes/length-inl.h"
#include "render/math/ray_columns.h"
#include "render/math/transform-inl.h"
#include "render/shape/placed.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

template <class L>
struct RayOf {
  Vec3Of<L> origin, direction;
};

/// The same rays with directions of unit length; depths along them are `length` times as long. Directions are
/// multiplied by the reciprocal, as POV-Ray does: surfaces that coincide are then decided by the same rounding.
template <class L>
struct UnitRayOf {
  L length;
  RayOf<L> ray;
};

template <class L>
HWY_INLINE UnitRayOf<L> unit_ray(const RayOf<L>& given) {
  const L length = exact_length(given.direction);
  return {length, {given.origin, given.direction * (1.0 / length)}};
}

/// One over each component of a direction, for trees of boxes; for 0 a number that is large and finite.
template <class L>
HWY_INLINE Vec3Of<L> finite_inverse(const Vec3Of<L>& d) {
  constexpr double kLarge = 1e300;
  const auto of = [](const L& component) HWY_ATTR {
    const L inverse = 1.0 / component;
    return select(abs(inverse) <= kLarge, inverse, copysign(L(kLarge), component));
  };
  return {of(d.x), of(d.y), of(d.z)};
}

/// Takes the crossings of some rays of a block.
struct SlotSink {
  Slot* const* slots;
  std::size_t at;  ///< where the rays stand in the block
  std::uint64_t of_vector;

  HWY_INLINE void operator()(std::size_t k, const Lanes& depth, const LanesMask& met, std::uint32_t face = 0) const {
    Slot& slot = *slots[k];
    store(depth, slot.depth, at);
    slot.rays |= (bits(met) & of_vector) << at;
    slot.face = face;
  }
  HWY_INLINE void operator()(std::size_t k, const Lanes& depth, const LanesMask& met, const Lanes& face) const {
    operator()(k, depth, met);
    slots[k]->has_faces = true;
    store(face, slots[k]->own_details().face, at);
  }
};

/// Takes the crossings of some rays of a block into lists.
struct SlotListSink {
  SlotLists& lists;
  std::size_t at;  ///< where the rays stand in the block
  std::uint64_t of_vector;

  HWY_INLINE void operator()(std::size_t, const Lanes& depth, const LanesMask& met, std::uint32_t face) const {
    double depths[Lanes::kCount];
    depth.store(depths);
    for (std::uint64_t left = bits(met) & of_vector; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
      lists.add(at + lane, depths[lane], face, {});
    }
  }
};

/// Those of a single ray, for a list with add(depth, face).
template <class List>
struct ListSink {
  List& list;

  void operator()(std::size_t, One depth, OneMask met, std::uint32_t face = 0) const {
    if (met.holds) list.add(depth.v, face);
  }
  void operator()(std::size_t, One depth, OneMask met, One face) const {
    if (met.holds) list.add(depth.v, static_cast<std::uint32_t>(face.v));
  }
};

/// visit(ray, i, of_vector) for the rays from the i-th on, in the space that `transform` leads from. In `of_vector` are
/// bits of those of them that count.
template <class Visit>
HWY_INLINE void for_each_vector(const Transform& transform, const RayColumns& rays, std::uint64_t who,
                                const Visit& visit) {
  const bool placed = !transform.is_identity();
  const Mat4& back = transform.inverse_matrix();
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    RayOf<Lanes> ray{load3<Lanes>(rays.origin, i), load3<Lanes>(rays.direction, i)};
    if (placed) ray = {point_times(ray.origin, back), direction_times(ray.direction, back)};
    visit(ray, i, of_vector);
  }
}
template <class Visit>
HWY_INLINE void for_each_vector(const RaysAndPlace& asked, const Visit& visit) {
  for_each_vector(asked.transform, asked.rays, asked.who, visit);
}

/// The same of points.
template <class Visit>
HWY_INLINE void for_each_vector(const Transform& transform, const Columns3<double>& points, std::uint64_t who,
                                const Visit& visit) {
  const bool placed = !transform.is_identity();
  const Mat4& back = transform.inverse_matrix();
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    auto p = load3<Lanes>(points, i);
    if (placed) p = point_times(p, back);
    visit(p, i, of_vector);
  }
}

template <class Formula>
HWY_INLINE void meet_rays(const Formula& formula, const RaysAndPlace& asked, Slots& slots) {
  const std::size_t first = slots.size();
  Slot* own[Formula::kSlots];
  for (Slot*& slot : own) {
    slot = slots.add(asked.shape);
    if (slot == nullptr) return slots.cut(first);
  }
  for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    meet(formula, ray, SlotSink{own, i, of_vector});
  });
  slots.drop_empty(first);
}

template <class Formula>
HWY_INLINE std::uint64_t points_inside(const Formula& formula, const Transform& transform, bool inverted,
                                       const Columns3<double>& points, std::uint64_t who) {
  std::uint64_t holding = 0;
  for_each_vector(transform, points, who, [&](const Vec3Of<Lanes>& p, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    holding |= (bits(inside(formula, p, inverted)) & of_vector) << i;
  });
  return holding;
}

/// Appends the crossings of one ray to the list.
template <class Formula, class List>
void meet_one(const Formula& formula, const Ray& ray, List& list) {
  meet(formula, RayOf<One>{everywhere<One>(ray.origin), everywhere<One>(ray.direction)}, ListSink<List>{list});
}
template <class Formula>
bool is_inside(const Formula& formula, const Vec3& point, bool inverted) {
  return inside(formula, everywhere<One>(point), inverted).holds;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

// Pairs of macros offer the formulas of a struct to others. The first of a pair stands in HWY_NAMESPACE, the second
// behind HWY_ONCE, where it defines those members of the struct that render/shape/placed.h tells of.

#define FIRSTLIGHT_MEET_KERNEL(Formula)                                                  \
  void meet_##Formula(const Formula& formula, const RaysAndPlace& asked, Slots& slots) { \
    meet_rays(formula, asked, slots);                                                    \
  }
#define FIRSTLIGHT_MEET_MEMBERS(Formula)                                    \
  HWY_EXPORT(meet_##Formula);                                               \
  void Formula::meet_block(const RaysAndPlace& asked, Slots& slots) const { \
    HWY_DYNAMIC_DISPATCH(meet_##Formula)(*this, asked, slots);              \
  }                                                                         \
  void Formula::meet(const Ray& ray, Met& met) const { HWY_NAMESPACE::meet_one(*this, ray, met); }

#define FIRSTLIGHT_INSIDE_KERNEL(Formula)                                                           \
  std::uint64_t inside_##Formula(const Formula& formula, const Transform& transform, bool inverted, \
                                 const Columns3<double>& points, std::uint64_t who) {               \
    return points_inside(formula, transform, inverted, points, who);                                \
  }
#define FIRSTLIGHT_INSIDE_MEMBERS(Formula)                                                                       \
  HWY_EXPORT(inside_##Formula);                                                                                  \
  std::uint64_t Formula::inside_block(const Transform& transform, bool inverted, const Columns3<double>& points, \
                                      std::uint64_t who) const {                                                 \
    return HWY_DYNAMIC_DISPATCH(inside_##Formula)(*this, transform, inverted, points, who);                      \
  }                                                                                                              \
  bool Formula::inside(const Vec3& point, bool inverted) const {                                                 \
    return HWY_NAMESPACE::is_inside(*this, point, inverted);                                                     \
  }

#endif
