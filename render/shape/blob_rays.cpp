#include "render/shape/blob_rays.h"

#include "render/math/polynomial.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/blob_rays.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/lane_shape-inl.h"

#include <algorithm>
#include <array>
#include <limits>

#ifndef FIRSTLIGHT_RENDER_SHAPE_BLOB_RAYS
#define FIRSTLIGHT_RENDER_SHAPE_BLOB_RAYS
namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-2;     ///< POV-Ray's for this shape
constexpr double kNegligible = 1e-3;  ///< a start nearer than this is taken for the ray's own

using Quartic = std::array<double, 5>;  ///< c[k] t^k

/// A place on a ray where it comes into an element's field, or leaves it.
struct Change {
  double at;
  std::uint32_t visit;
  bool enters;

  /// Where two changes are at the same place, that of the later visit comes first.
  static bool comes_later(const Change& a, const Change& b) {
    return a.at > b.at || (a.at == b.at && (a.visit < b.visit || (a.visit == b.visit && b.enters)));
  }
};

/// An element, and the rays that come through its field.
struct Visit {
  const BlobElement* element;
  std::uint64_t rays;
  std::array<Column<double>, 5> along;  ///< its field along them
};

/// A ray's way through the fields. The quartic of their sum is in a parameter that goes from about 0 to 1 between the
/// first change and the last.
struct Way {
  std::vector<Change> changes;  ///< a heap from begin() on, the first on top: most are behind the surface that is seen
  double start;
  double scale;
  Quartic sum;
  int count;  ///< fields that the ray is in

  void add(std::uint32_t visit, double begin, double end) {
    changes.push_back({begin, visit, true});
    changes.push_back({end, visit, false});
  }
  /// Sets where the parameter is 0, and what 1 is, as depths of the ray.
  void begin(double threshold) {
    const auto [first, last] = std::ranges::minmax(changes, {}, &Change::at);
    start = first.at < kNegligible ? 0.0 : first.at;
    scale = std::max(first.at - start, last.at - start);
    if (scale == 0.0) scale = 1.0;
    std::ranges::make_heap(changes, Change::comes_later);
    sum = {-threshold, 0.0, 0.0, 0.0, 0.0};
    count = 0;
  }
  /// Goes on to the next part with one sum of fields. False: there is none.
  bool advance(const std::vector<Visit>& visits, std::size_t ray, double& low, double& high) {
    while (changes.size() > 1) {
      std::ranges::pop_heap(changes, Change::comes_later);
      const Change change = changes.back();
      changes.pop_back();
      const std::array<Column<double>, 5>& along = visits[change.visit].along;
      const double sign = change.enters ? 1.0 : -1.0;
      for (std::size_t k = 0; k < 5; ++k) sum[k] += sign * along[k][ray];
      count += change.enters ? 1 : -1;
      if (count == 0) continue;
      low = (change.at - start) / scale;
      high = (changes.front().at - start) / scale;
      if (high - low >= kEpsilon) return true;
    }
    return false;
  }
};

/// Ways of the rays of a block, and the fields on them; a thread keeps them for the next time.
struct Ways {
  std::vector<Visit> visits;
  std::size_t visit_count = 0;
  std::array<Way, kRaysAtOnce> of;

  Visit& add_visit(const BlobElement& element, std::uint64_t rays) {
    if (visit_count == visits.size()) visits.emplace_back();
    Visit& visit = visits[visit_count++];
    visit.element = &element;
    visit.rays = rays;
    return visit;
  }
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

using Kind = BlobElement::Kind;

/// Parts of rays.
template <class L>
struct Chord {
  L begin, end;
  MaskOf<L> counts;
};

/// A ray in the element's space, from its middle or foot.
template <class L>
HWY_INLINE RayOf<L> local_ray(const BlobElement& element, const RayOf<L>& ray) {
  if (element.placement.is_identity()) return ray;
  const Mat4& back = element.placement.inverse_matrix();
  return {point_times(ray.origin, back), direction_times(ray.direction, back)};
}

/// Cuts off the part behind the ray's origin, which does not count.
template <class L>
HWY_INLINE Chord<L> seen(const L& begin, const L& end, const L& length, const MaskOf<L>& counts) {
  const auto ahead = [&](const L& t) HWY_ATTR {
    const L depth = t / length;
    return select(depth < kNearest, L(0.0), depth);
  };
  const L from = ahead(begin);
  const L to = ahead(end);
  return {from, to, counts & (from < to)};
}

template <class L>
HWY_INLINE Chord<L> cross_middle(const BlobElement& element, const RayOf<L>& ray, const L& length) {
  const Vec3Of<L>& p = ray.origin;
  const Vec3Of<L>& d = ray.direction;
  L begin = kBoundingHuge;
  L end = -kBoundingHuge;
  const auto include = [&](const L& t, const MaskOf<L>& counts) HWY_ATTR {
    begin = select(counts, min(begin, t), begin);
    end = select(counts, max(end, t), end);
  };
  const L a = d.x * d.x + d.y * d.y;
  const L b = p.x * d.x + p.y * d.y;
  const L squared = b * b - a * (p.x * p.x + p.y * p.y - element.radius_squared);
  const auto meets = (a > kEpsilon) & (squared > kEpsilon);
  const L half = sqrt(squared);
  for (const L& root : {half, -half}) {
    const L t = (root - b) / a;
    const L z = p.z + t * d.z;
    include(t, meets & (z >= 0.0) & (z <= element.height));
  }
  const auto steep = abs(d.z) > kEpsilon;
  for (const double z : {0.0, element.height}) {
    const L t = (z - p.z) / d.z;
    const L x = p.x + t * d.x;
    const L y = p.y + t * d.y;
    include(t, steep & (x * x + y * y <= element.radius_squared));
  }
  return seen(begin, end, length, begin == begin);
}

/// Where rays with directions of unit length are in the field. [POV-Ray 3.7]
template <class L>
HWY_INLINE Chord<L> crossed(const BlobElement& element, const RayOf<L>& given) {
  const auto [length, ray] = unit_ray(local_ray(element, given));
  if (element.kind == Kind::middle) return cross_middle(element, ray, length);
  const Vec3Of<L> from = ray.origin - everywhere<L>(element.foot());
  const L b = dot(from, ray.direction);
  const L squared = b * b - dot(from, from) + element.radius_squared;
  const auto meets = !(squared < kEpsilon);
  const L half = sqrt(squared);
  const L begin = -b - half;
  const L end = -b + half;
  if (element.kind == Kind::ball) return seen(begin, end, length, meets);
  const double side = element.kind == Kind::base ? -1.0 : 1.0;
  const auto enters_out = side * (from.z + begin * ray.direction.z) <= 0.0;
  const auto leaves_out = side * (from.z + end * ray.direction.z) <= 0.0;
  const L at_plane = -from.z / ray.direction.z;
  const L cut = select(at_plane < kNearest, L(0.0), at_plane);
  const L first = select(enters_out, cut, begin) / length;
  const L last = select(without(leaves_out, enters_out), cut, end) / length;
  return {first, last, without(meets & (first < last), enters_out & leaves_out)};
}

/// The element's field along rays whose directions may have any length.
template <class L>
HWY_INLINE void field_along(const BlobElement& element, const RayOf<L>& ray, L (&c)[5]) {
  auto [p, d] = local_ray(element, ray);
  p = p - everywhere<L>(element.foot());
  if (element.kind == Kind::middle) p.z = d.z = 0.0;
  const double c0 = element.c0;
  const double c1 = element.c1;
  const L t0 = dot(p, p);
  const L t1 = dot(p, d);
  const L t2 = dot(d, d);
  c[0] = t0 * (c0 * t0 + c1) + element.c2;
  c[1] = 2.0 * t1 * (2.0 * c0 * t0 + c1);
  c[2] = 2.0 * c0 * (2.0 * t1 * t1 + t0 * t2) + c1 * t2;
  c[3] = 4.0 * c0 * t1 * t2;
  c[4] = c0 * t2 * t2;
}

/// The rays in the blob's space, with directions of unit length.
struct OwnRays {
  RayColumns rays;
  Columns3<double> inverse;  ///< one over each direction; for 0 a number that is large and finite
  Column<double> length;
};

HWY_INLINE void turn(const Transform& transform, const RayColumns& rays, std::uint64_t who, OwnRays& own) {
  for_each_vector(transform, rays, who, [&](const RayOf<Lanes>& given, std::size_t i, std::uint64_t) HWY_ATTR {
    const UnitRayOf<Lanes> unit = unit_ray(given);
    const Vec3Of<Lanes>& d = unit.ray.direction;
    store3(unit.ray.origin, own.rays.origin, i);
    store3(d, own.rays.direction, i);
    store3(finite_inverse(d), own.inverse, i);
    store(unit.length, own.length, i);
  });
}

/// Notes for the rays in `who` where they come through the element's field.
void visit_element(const BlobElement& element, const RayColumns& rays, std::uint64_t who, Ways& ways) {
  const auto number = static_cast<std::uint32_t>(ways.visit_count);
  std::uint64_t crossing = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    const auto chord = crossed(element, RayOf<Lanes>{load3<Lanes>(rays.origin, i), load3<Lanes>(rays.direction, i)});
    const std::uint64_t here = bits(chord.counts) & of_vector;
    if (here == 0) continue;
    crossing |= here << i;
    double begin[Lanes::kCount];
    double end[Lanes::kCount];
    chord.begin.store(begin);
    chord.end.store(end);
    for (std::uint64_t left = here; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
      ways.of[i + lane].add(number, begin[lane], end[lane]);
    }
  }
  if (crossing != 0) ways.add_visit(element, crossing);
}

/// Finds the fields along the rays, whose parameters begin at `start` and go by `scale`.
void find_fields(const RayColumns& rays, const Column<double>& start, const Column<double>& scale, Ways& ways) {
  for (std::size_t v = 0; v < ways.visit_count; ++v) {
    Visit& visit = ways.visits[v];
    for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
      if ((visit.rays >> i & kAllLanes) == 0) continue;
      const auto direction = load3<Lanes>(rays.direction, i);
      const RayOf<Lanes> ray{load3<Lanes>(rays.origin, i) + direction * load<Lanes>(start, i),
                             direction * load<Lanes>(scale, i)};
      Lanes c[5];
      field_along(*visit.element, ray, c);
      for (std::size_t k = 0; k < 5; ++k) store(c[k], visit.along[k], i);
    }
  }
}

void meet_field(const BlobField& field, const Transform& transform, const RayColumns& rays, std::uint64_t who,
                const Column<double>* low, std::vector<BlobCrossing>& out) {
  thread_local Ways ways;
  ways.visit_count = 0;
  for (std::uint64_t left = who; left != 0; left &= left - 1) {
    ways.of[static_cast<std::size_t>(__builtin_ctzll(left))].changes.clear();
  }
  OwnRays own;
  turn(transform, rays, who, own);
  if (field.tree == nullptr) {
    for (const BlobElement& element : field.elements) visit_element(element, own.rays, who, ways);
  } else {
    field.tree->for_each_met(own.rays, own.inverse, who, [&](std::uint32_t element, std::uint64_t here) {
      visit_element(field.elements[element], own.rays, here, ways);
    });
  }
  Column<double> start;
  Column<double> scale;
  std::uint64_t open = 0;
  for (std::uint64_t left = who; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    Way& way = ways.of[i];
    if (way.changes.empty()) continue;
    open |= std::uint64_t{1} << i;
    way.begin(field.threshold);
    start[i] = way.start;
    scale[i] = way.scale;
  }
  if (open == 0) return;
  find_fields(own.rays, start, scale, ways);

  // Part by part, all rays at once.
  PolynomialColumns sums;
  sums.order = 4;
  Column<double> root;
  while (open != 0) {
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
      Way& way = ways.of[i];
      if (!way.advance(ways.visits, i, sums.low[i], sums.high[i])) {
        open &= ~(std::uint64_t{1} << i);
        continue;
      }
      for (std::size_t k = 0; k < 5; ++k) sums.c[k][i] = way.sum[k];
    }
    RootColumns roots(sums, open);
    for (std::uint64_t found = open; (found = roots.next(found, root)) != 0;) {
      for (std::uint64_t left = found; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
        const double depth = (root[i] * scale[i] + start[i]) / own.length[i];
        if (!(depth > kNearest && depth < kMaxDistance)) continue;
        out.push_back({i, depth});
        if (low == nullptr || !(depth > (*low)[i])) continue;
        open &= ~(std::uint64_t{1} << i);
        found &= ~(std::uint64_t{1} << i);
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(meet_field);

void meet_blob(const BlobField& field, const Transform& transform, const RayColumns& rays, std::uint64_t who,
               const Column<double>* low, std::vector<BlobCrossing>& out) {
  HWY_DYNAMIC_DISPATCH(meet_field)(field, transform, rays, who, low, out);
}

}  // namespace firstlight::render
#endif
