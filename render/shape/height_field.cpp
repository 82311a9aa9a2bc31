#include "render/shape/height_field.h"

#include "render/math/transform.h"
#include "render/shape/box.h"
#include "render/shape/land.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/height_field.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/box-inl.h"
#include "render/shape/lane_shape-inl.h"

#include <cstddef>
#include <memory>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

constexpr double kNearest = 1e-6;       ///< POV-Ray's for this shape
constexpr double kTriangleRoom = 1e-4;  ///< so far beyond its sides a triangle is met
constexpr double kShrink = Land::kShrink;
/// Smaller blocks than this are tested with a little more of a ray than there is in them, as cells are: a triangle is
/// met a little beyond its sides.
constexpr double kExactSize = 16.0;

/// The part of rays within the box of a land.
template <class L>
struct WithinBox {
  MaskOf<L> any;
  L enters, leaves;
};
template <class L>
struct BoxSink {
  WithinBox<L>& within;

  HWY_INLINE void operator()(std::size_t k, const L& depth, const MaskOf<L>& met, const L&) const {
    if (k == 0) {
      within.enters = select(met, max(depth, L(kNearest)), L(kNearest));
    } else {
      within.leaves = depth;
      within.any = met;
    }
  }
};

/// One axis of the grid along rays.
template <class L>
struct GridAxis {
  L origin, direction, inverse;
  L endless;     ///< kBoundless where rays never come to a border
  L forward;     ///< 1 where rays go up along the axis, else 0
  L step;        ///< likewise, else -1
  double cells;  ///< how many there are
};
template <class L>
HWY_INLINE GridAxis<L> grid_axis(const L& origin, const L& direction, int cells) {
  const auto still = direction == 0.0, upwards = direction > 0.0;
  return {origin,
          direction,
          select(still, L(0.0), 1.0 / direction),
          select(still, L(kBoundless), L(0.0)),
          select(upwards, L(1.0), L(0.0)),
          select(upwards, L(1.0), L(-1.0)),
          static_cast<double>(cells)};
}
/// Depth of the border of block `at` that is passed next.
template <class L>
HWY_INLINE L next_border(const GridAxis<L>& axis, const L& at, const L& size) {
  return ((at + axis.forward) * size - axis.origin) * axis.inverse + axis.endless;
}
/// Which part of block `whole` rays are in at a depth, of parts of a size, each one of `per_cell` a cell.
template <class L>
HWY_INLINE L part_at(const GridAxis<L>& axis, const L& depth, const L& whole, const L& per_cell) {
  const L first = whole * kShrink;
  const L last = min(first + (kShrink - 1.0), floor((axis.cells - 1.0) * per_cell));
  return min(max(floor((axis.origin + depth * axis.direction) * per_cell), first), last);
}

/// Rays on their way over a land, each at a block of some level: down into a block whose heights it passes between,
/// else on to the next; and up when that is in another one of the level above.
template <class L>
struct LandWalk {
  const Land& land;
  RayOf<L> ray;
  GridAxis<L> x_axis, z_axis;
  L leaves;
  MaskOf<L> going;
  L x, z, size, level;
  L from, to;  ///< depths between which a ray is in its block; `to` is known at cells
};

/// The heights of each ray's block. A ray that has left the land goes no farther.
template <class L>
HWY_INLINE void look_up(LandWalk<L>& walk, const MaskOf<L>& who, L& low, L& high) {
  double x[L::kCount], z[L::kCount], level[L::kCount], lows[L::kCount] = {}, highs[L::kCount] = {};
  walk.x.store(x);
  walk.z.store(z);
  walk.level.store(level);
  unsigned gone = 0;
  for (unsigned left = bits(who); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(left));
    const Land::Level& blocks = walk.land.levels()[static_cast<std::size_t>(level[i])];
    if (x[i] >= 0.0 && z[i] >= 0.0 && x[i] < blocks.columns && z[i] < blocks.rows) {
      const Land::Span& span = blocks.at(static_cast<int>(x[i]), static_cast<int>(z[i]));
      lows[i] = span.low;
      highs[i] = span.high;
    } else {
      gone |= 1u << i;
    }
  }
  low = L::load(lows);
  high = L::load(highs);
  walk.going = without(walk.going, L::mask_of(gone));
}

/// On from their blocks, which they leave at `next_x` or `next_z`.
template <class L>
HWY_INLINE void go_on(LandWalk<L>& walk, const MaskOf<L>& who, const L& next_x, const L& next_z) {
  const auto to = min(min(next_x, next_z), walk.leaves);
  const auto over_x = next_x <= next_z;
  const L x = select(over_x, walk.x + walk.x_axis.step, walk.x);
  const L z = select(over_x, walk.z, walk.z + walk.z_axis.step);
  const L whole_x = floor(x * (1.0 / kShrink)), whole_z = floor(z * (1.0 / kShrink));
  const auto out = (whole_x != floor(walk.x * (1.0 / kShrink))) | (whole_z != floor(walk.z * (1.0 / kShrink)));
  const auto ended = (to >= walk.leaves) | (walk.level >= static_cast<double>(walk.land.levels().size() - 1));
  walk.going = without(walk.going, who & ended);
  const auto moving = without(who, ended), rising = moving & out;
  walk.x = select(rising, whole_x, select(moving, x, walk.x));
  walk.z = select(rising, whole_z, select(moving, z, walk.z));
  walk.size = select(rising, walk.size * kShrink, walk.size);
  walk.level = select(rising, walk.level + 1.0, walk.level);
  walk.from = select(moving, to, walk.from);
}

/// Into the part of their blocks where they are.
template <class L>
HWY_INLINE void go_down(LandWalk<L>& walk, const MaskOf<L>& who) {
  const L size = walk.size * (1.0 / kShrink);
  const L per_cell = 1.0 / size;
  walk.x = select(who, part_at(walk.x_axis, walk.from, walk.x, per_cell), walk.x);
  walk.z = select(who, part_at(walk.z_axis, walk.from, walk.z, per_cell), walk.z);
  walk.size = select(who, size, walk.size);
  walk.level = select(who, walk.level - 1.0, walk.level);
}

/// Goes on until each ray has come to a cell whose heights it passes between, or to its end. Returns those at a cell.
template <class L>
HWY_INLINE MaskOf<L> find_cells(LandWalk<L>& walk) {
  auto found = L::first(0);
  for (;;) {
    const auto open = without(walk.going, found);
    if (!any(open)) return found & walk.going;
    L low, high;
    look_up(walk, open, low, high);
    const L next_x = next_border(walk.x_axis, walk.x, walk.size), next_z = next_border(walk.z_axis, walk.z, walk.size);
    const L to = min(min(next_x, next_z), walk.leaves);
    const L more = select(walk.size < kExactSize, kTriangleRoom * (to - walk.from) + kNearest, L(0.0));
    const L& y = walk.ray.origin.y;
    const L& slope = walk.ray.direction.y;
    const L first = y + (walk.from - more) * slope, last = y + (to + more) * slope;
    const auto passing = (max(first, last) >= low - Land::kRoom) & (min(first, last) <= high + Land::kRoom);
    const auto there = open & passing & (walk.level == 0.0);
    walk.to = select(there, to, walk.to);
    found = found | there;
    const auto down = without(open & passing, there);
    go_on(walk, without(open, passing) & walk.going, next_x, next_z);
    if (any(down)) go_down(walk, down);
  }
}

/// Calls met(lane, depth, face) for the triangles of the cells where rays are; it returns whether the ray goes on.
template <class L, class Met>
HWY_INLINE void meet_triangles(LandWalk<L>& walk, const MaskOf<L>& who, const L& enters, const Met& met) {
  const auto& [o, d] = walk.ray;
  double x[L::kCount], z[L::kCount], heights[4][L::kCount] = {};
  walk.x.store(x);
  walk.z.store(z);
  for (unsigned left = bits(who); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(left));
    const auto column = static_cast<int>(x[i]), row = static_cast<int>(z[i]);
    for (int k = 0; k < 4; ++k) {
      heights[k][i] = walk.land.height(column + (k & 1), row + (k >> 1));
    }
  }
  const L y[4] = {L::load(heights[0]), L::load(heights[1]), L::load(heights[2]), L::load(heights[3])};
  unsigned ended = 0;
  for (const bool is_far : {false, true}) {
    const Vec3Of<L> normal{is_far ? y[2] - y[3] : y[0] - y[1], 1.0, is_far ? y[1] - y[3] : y[0] - y[2]};
    const Vec3Of<L> corner{is_far ? walk.x + 1.0 : walk.x, is_far ? y[3] : y[0], is_far ? walk.z + 1.0 : walk.z};
    const L approach = dot(normal, d);
    const L depth = dot(normal, corner - o) / approach;
    const auto counts = (abs(approach) > kEpsilon) & (depth >= enters) & (depth <= walk.leaves);
    const L s = o.x + depth * d.x - walk.x, t = o.z + depth * d.z - walk.z;
    const auto is_in = is_far ? (s <= 1.0 + kTriangleRoom) & (t <= 1.0 + kTriangleRoom) & (s + t >= 1.0 - kTriangleRoom)
                              : (s >= -kTriangleRoom) & (t >= -kTriangleRoom) & (s + t <= 1.0 + kTriangleRoom);
    double depths[L::kCount];
    depth.store(depths);
    for (unsigned left = bits(who & counts & is_in); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctz(left));
      const std::uint32_t face = walk.land.face(static_cast<int>(x[i]), static_cast<int>(z[i]), is_far);
      if (!met(i, depths[i], face)) ended |= 1u << i;
    }
  }
  walk.going = without(walk.going, L::mask_of(ended));
}

/// Calls met(lane, depth, face), which returns whether that ray is to go on, for each crossing up to `high` of the rays
/// in `who`, in about the order of depths.
template <class L, class Met>
HWY_INLINE void meet(const Land& land, const RayOf<L>& ray, const MaskOf<L>& who, const L& high, const Met& met) {
  const Box3 around = land.box();
  WithinBox<L> within{L::first(0), L(kNearest), L(0.0)};
  meet(AxisBox{around.min, around.max}, ray, BoxSink<L>{within});
  const L leaves = min(within.leaves, high);
  const auto going = who & within.any & (within.enters <= leaves);
  if (!any(going)) return;
  const Land::Level& cells = land.levels().front();
  const auto top = static_cast<double>(land.levels().size() - 1);
  double size = 1.0;
  for (std::size_t level = 1; level < land.levels().size(); ++level) size *= kShrink;
  LandWalk<L> walk{land,
                   ray,
                   grid_axis(ray.origin.x, ray.direction.x, cells.columns),
                   grid_axis(ray.origin.z, ray.direction.z, cells.rows),
                   leaves,
                   going,
                   L(0.0),
                   L(0.0),
                   L(size),
                   L(top),
                   within.enters,
                   leaves};
  for (;;) {
    const auto at_cells = find_cells(walk);
    if (!any(at_cells)) return;
    meet_triangles(walk, at_cells, within.enters, met);
    go_on(walk, at_cells & walk.going, next_border(walk.x_axis, walk.x, walk.size),
          next_border(walk.z_axis, walk.z, walk.size));
  }
}

void meet_land_in_block(const Land& land, const RaysAndPlace& asked, Slots& slots) {
  SlotLists lists(asked.shape, slots, true);
  const DepthWindow* window = asked.nearest_only;
  for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t of_vector) HWY_ATTR {
    const Lanes high = window ? load<Lanes>(window->high, i) : Lanes(kBoundless);
    meet(land, ray, Lanes::mask_of(static_cast<unsigned>(of_vector)), high,
         [&](std::size_t lane, double depth, std::uint32_t face) {
           lists.add(i + lane, depth, face, {});
           return !slots.overflowed() && (window == nullptr || !(depth > window->low[i + lane]));
         });
  });
}

/// Appends the crossings of one ray, in the land's own space. Those behind one beyond `low` are not looked for.
void meet_land(const Land& land, const Ray& ray, double low, double high, const Shape& shape,
               std::vector<Crossing>& out) {
  const RayOf<One> one{everywhere<One>(ray.origin), everywhere<One>(ray.direction)};
  meet(land, one, One::first(1), One(high), [&](std::size_t, double depth, std::uint32_t face) {
    out.push_back({depth, &shape, 0, face, {}});
    return !(depth > low);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(meet_land_in_block);

namespace {

/// A landscape where it stands.
class HeightField final : public Shape {
 public:
  HeightField(std::shared_ptr<const Land> land, Transform transform, bool inverted)
      : land_(std::move(land)), transform_(std::move(transform)), inverted_(inverted) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    HWY_NAMESPACE::meet_land(*land_, transform_.inverse_ray(ray), kBoundless, kBoundless, *this, out);
  }
  void nearest(const Ray& ray, double low, double high, std::vector<Crossing>& out) const override {
    HWY_NAMESPACE::meet_land(*land_, transform_.inverse_ray(ray), low, high, *this, out);
  }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    HWY_DYNAMIC_DISPATCH(meet_land_in_block)(*land_, {*this, transform_, rays, who, nearest_only}, slots);
  }
  bool is_over_lanes() const override { return true; }
  bool inside(const Vec3& point) const override { return land_->holds(transform_.inverse_point(point)) != inverted_; }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override {
    Vec3 n(0.0);
    if (land_->is_smooth()) {
      land_->smooth_normals(transform_.inverse_point(point), [&](const Vec3& corner, double weight) {
        n += transform_.normal(corner).normalized() * weight;
      });
    } else {
      n = transform_.normal(land_->flat_normal(crossing.face));
    }
    n.normalize();
    return inverted_ ? -n : n;
  }
  Box3 bounds() const override { return transform_.box(land_->box()); }
  ShapePtr placed(const Transform& transform) const override {
    return std::make_shared<HeightField>(land_, transform_.then(transform), inverted_);
  }
  ShapePtr inverted() const override { return std::make_shared<HeightField>(land_, transform_, !inverted_); }

 private:
  std::shared_ptr<const Land> land_;
  Transform transform_;
  bool inverted_;
};

}  // namespace

ShapePtr make_height_field(HeightFieldParameters parameters) {
  auto land = std::make_shared<const Land>(std::move(parameters));
  return std::make_shared<HeightField>(land, land->to_unit(), false);
}

bool is_height_field(const Shape& shape) { return dynamic_cast<const HeightField*>(&shape) != nullptr; }

}  // namespace firstlight::render
#endif
