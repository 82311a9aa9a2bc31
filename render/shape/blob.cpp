#include "render/shape/blob.h"

#include "render/math/box_tree.h"
#include "render/math/polynomial.h"
#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kNearest = 1e-2;       ///< POV-Ray's for this shape
constexpr double kInsideRoom = 1e-6;    ///< likewise, of the field
constexpr double kNegligible = 1e-3;    ///< a start nearer than this is taken for the ray's own
constexpr std::size_t kFew = 8;         ///< elements that are asked one by one

using Quartic = std::array<double, 5>;  ///< c[k] t^k

/// A part of a ray.
struct Interval {
  double begin;
  double end;
};

/// A ball, or one of the three parts of a cylinder: a half ball at each end, and what is between. Its field is
/// c0 d^4 + c1 d^2 + c2, d being the distance from the middle or the axis.
struct Element {
  enum class Kind : std::uint8_t { ball, base, middle, top };

  Kind kind;
  Vec3 center;          ///< of a ball
  double height = 0.0;  ///< of a cylinder, which stands on the origin along z
  double radius_squared;
  double c0, c1, c2;
  Transform placement;  ///< to the blob's space
  std::uint32_t texture;

  Vec3 local(const Vec3& point) const { return placement.is_identity() ? point : placement.inverse_point(point); }
  Vec3 foot() const { return kind == Kind::ball ? center : Vec3(0.0, 0.0, kind == Kind::top ? height : 0.0); }

  /// The step from the middle or the axis to the point, in the element's space; nothing where there is no field.
  std::optional<Vec3> from_middle(const Vec3& point) const {
    const Vec3 there = local(point);
    Vec3 step = there - foot();
    if (kind == Kind::base && step.z > 0.0) return std::nullopt;
    if (kind == Kind::top && step.z < 0.0) return std::nullopt;
    if (kind == Kind::middle) {
      if (there.z < 0.0 || there.z > height) return std::nullopt;
      step.z = 0.0;
    }
    if (step.length2() > radius_squared) return std::nullopt;
    return step;
  }
  double field(const Vec3& point) const {
    const std::optional<Vec3> step = from_middle(point);
    if (!step) return 0.0;
    const double d2 = step->length2();
    return d2 * (d2 * c0 + c1) + c2;
  }
  /// Minus the gradient of its field.
  Vec3 normal(const Vec3& point) const {
    const std::optional<Vec3> step = from_middle(point);
    if (!step) return Vec3(0.0);
    return placement.normal(*step) * (-2.0 * c0 * step->length2() - c1);
  }
  /// Its field along a ray whose direction may have any length.
  Quartic along(const Vec3& origin, const Vec3& direction) const {
    Vec3 p = local(origin) - foot();
    Vec3 d = placement.is_identity() ? direction : placement.inverse_direction(direction);
    if (kind == Kind::middle) p.z = d.z = 0.0;
    const double t0 = p.dot(p);
    const double t1 = p.dot(d);
    const double t2 = d.dot(d);
    return {t0 * (c0 * t0 + c1) + c2, 2.0 * t1 * (2.0 * c0 * t0 + c1), 2.0 * c0 * (2.0 * t1 * t1 + t0 * t2) + c1 * t2,
            4.0 * c0 * t1 * t2, c0 * t2 * t2};
  }
  /// Where a ray with a direction of unit length is in the field. [POV-Ray 3.7]
  std::optional<Interval> crossed(const Ray& given) const {
    const auto [length, ray] = UnitRay(placement.is_identity() ? given : placement.inverse_ray(given));
    if (kind == Kind::middle) return cross_middle(ray, length);
    const Vec3 from = ray.origin - foot();
    const double b = from.dot(ray.direction);
    const double squared = b * b - from.dot(from) + radius_squared;
    if (squared < kEpsilon) return std::nullopt;
    const double half = std::sqrt(squared);
    Interval chord{-b - half, -b + half};
    if (kind == Kind::ball) return seen(chord, length);
    const double side = kind == Kind::base ? -1.0 : 1.0;
    const bool enters_out = side * (from.z + chord.begin * ray.direction.z) <= 0.0;
    const bool leaves_out = side * (from.z + chord.end * ray.direction.z) <= 0.0;
    if (enters_out && leaves_out) return std::nullopt;
    if (enters_out || leaves_out) {
      const double cut = -from.z / ray.direction.z;
      (enters_out ? chord.begin : chord.end) = cut < kNearest ? 0.0 : cut;
    }
    return Interval{chord.begin / length, chord.end / length};
  }
  Box3 bounds() const {
    const double reach = kind == Kind::middle ? std::sqrt(radius_squared + 0.25 * height * height) : std::sqrt(radius_squared);
    const Vec3 middle = kind == Kind::middle ? Vec3(0.0, 0.0, 0.5 * height) : foot();
    if (placement.is_identity()) return Box3(middle - Vec3(reach), middle + Vec3(reach));
    const Vec3 there = placement.point(middle);
    const Vec3 sides = placement.box(Box3(Vec3(0.0), Vec3(reach))).size();
    const double longest = std::max({sides.x, sides.y, sides.z});
    const double room = std::sqrt(longest * longest + kEpsilon);
    return Box3(there - Vec3(room), there + Vec3(room));
  }

 private:
  /// Cuts off the part behind the ray's origin, which does not count.
  static std::optional<Interval> seen(const Interval& chord, double length) {
    const auto ahead = [&](double depth) { return depth / length < kNearest ? 0.0 : depth / length; };
    const Interval result{ahead(chord.begin), ahead(chord.end)};
    return result.begin < result.end ? std::optional(result) : std::nullopt;
  }
  std::optional<Interval> cross_middle(const Ray& ray, double length) const {
    const Vec3& p = ray.origin;
    const Vec3& d = ray.direction;
    Interval chord{kBoundingHuge, -kBoundingHuge};
    const auto include = [&chord](double t) {
      chord.begin = std::min(chord.begin, t);
      chord.end = std::max(chord.end, t);
    };
    const double a = d.x * d.x + d.y * d.y;
    if (a > kEpsilon) {
      const double b = p.x * d.x + p.y * d.y;
      const double squared = b * b - a * (p.x * p.x + p.y * p.y - radius_squared);
      if (squared > kEpsilon) {
        for (const double root : {std::sqrt(squared), -std::sqrt(squared)}) {
          const double t = (root - b) / a;
          const double z = p.z + t * d.z;
          if (z >= 0.0 && z <= height) include(t);
        }
      }
    }
    if (std::abs(d.z) > kEpsilon) {
      for (const double z : {0.0, height}) {
        const double t = (z - p.z) / d.z;
        const double x = p.x + t * d.x;
        const double y = p.y + t * d.y;
        if (x * x + y * y <= radius_squared) include(t);
      }
    }
    return seen(chord, length);
  }
};

/// A place on a ray where it comes into an element's field, or leaves it.
struct Change {
  double at;
  std::uint32_t element;
  bool enters;
};

/// A blob in its own space.
struct Blob {
  static constexpr bool kIsLarge = true;

  double threshold;
  std::vector<Element> elements;
  std::optional<BoxTree> tree;  ///< over the elements' boxes; none of few
  Box3 positive;                ///< around the elements that add to the field
  Box3 all;

  explicit Blob(const BlobParameters& parameters) : threshold(parameters.threshold) {
    for (const BlobParameters::Component& component : parameters.components) add(component);
    std::vector<Box3> boxes;
    for (const Element& element : elements) {
      boxes.push_back(element.bounds());
      all.extendBy(boxes.back());
      if (element.c2 > 0.0) positive.extendBy(boxes.back());
    }
    if (elements.size() > kFew) tree.emplace(boxes);
  }

  void meet(const Ray& given, Met& met) const {
    const UnitRay unit_ray(given);
    const double length = unit_ray.length;
    const Ray& ray = unit_ray.ray;
    thread_local std::vector<Change> changes;
    thread_local std::vector<Quartic> fields;  // of the elements whose field the ray is in
    changes.clear();
    fields.resize(std::max(fields.size(), elements.size()));
    for_each_met(ray, [&](std::uint32_t element) { add_changes(ray, element, changes); });
    if (changes.empty()) return;
    // The quartic is in a parameter that goes from about 0 to 1 between the first change and the last.
    const double start = changes.front().at < kNegligible ? 0.0 : changes.front().at;
    double scale = changes.front().at - start;
    for (Change& change : changes) {
      change.at -= start;
      scale = std::max(scale, change.at);
    }
    if (scale == 0.0) scale = 1.0;
    for (Change& change : changes) change.at /= scale;
    const Vec3 origin = ray.at(start);
    const Vec3 direction = ray.direction * scale;

    Quartic sum{-threshold, 0.0, 0.0, 0.0, 0.0};
    int count = 0;
    for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
      Quartic& field = fields[changes[i].element];
      if (changes[i].enters) {
        field = elements[changes[i].element].along(origin, direction);
        for (std::size_t k = 0; k < 5; ++k) sum[k] += field[k];
        ++count;
      } else {
        for (std::size_t k = 0; k < 5; ++k) sum[k] -= field[k];
        if (--count == 0) continue;
      }
      const double low = changes[i].at;
      const double high = changes[i + 1].at;
      if (std::abs(high - low) < kEpsilon) continue;
      PolynomialRoots roots(sum, low, high);
      for (double t; !met.is_enough() && roots.next(t);) {
        const double depth = (t * scale + start) / length;
        if (depth > kNearest && depth < kMaxDistance) met.add(depth);
      }
      if (met.is_enough()) return;
    }
  }
  bool inside(const Vec3& point, bool inverted) const {
    double sum = 0.0;
    for_each_around(point, [&](const Element& element) { sum += element.field(point); });
    return (sum > threshold - kInsideRoom) != inverted;
  }
  Vec3 normal(const Vec3& point, const Crossing&) const {
    Vec3 sum(0.0);
    for_each_around(point, [&](const Element& element) { sum += element.normal(point); });
    return sum == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : sum.normalized();
  }
  /// Each element's has the share that its field has of all.
  void textures(const SurfacePlaces& places, std::size_t first, std::size_t end,
                std::vector<TextureShare>& out) const {
    for (std::size_t place = first; place < end; ++place) {
      const Vec3 point = places.point.vector(place);
      const std::size_t begin = out.size();
      double sum = 0.0;
      for_each_around(point, [&](const Element& element) {
        const double weight = std::abs(element.field(point));
        if (!(weight > 0.0)) return;
        out.push_back({static_cast<std::uint32_t>(place), element.texture, weight});
        sum += weight;
      });
      for (std::size_t i = begin; i < out.size(); ++i) out[i].weight /= sum;
    }
  }
  Box3 bounds() const { return threshold > 0.0 ? positive : all; }
  Box3 given_bounds() const { return positive; }
  Box3 inside_bounds() const { return threshold > kInsideRoom ? positive : boundless_box(); }

 private:
  void add(const BlobParameters::Component& component) {
    const double r2 = component.radius * component.radius;
    Element element{Element::Kind::ball, component.center, 0.0, r2, component.strength / (r2 * r2),
                    -2.0 * component.strength / r2, component.strength, component.placement, component.texture};
    if (component.kind == BlobParameters::Component::Kind::sphere) {
      elements.push_back(element);
      return;
    }
    const Vec3 axis = component.end - component.center;
    element.height = axis.length();
    element.placement = from_canonical(component.center, unit(axis), 1.0, 1.0).then(component.placement);
    for (const Element::Kind kind : {Element::Kind::middle, Element::Kind::base, Element::Kind::top}) {
      element.kind = kind;
      elements.push_back(element);
    }
  }
  template <class Visit>
  void for_each_met(const Ray& ray, const Visit& visit) const {
    if (!tree) {
      for (std::uint32_t i = 0; i < elements.size(); ++i) visit(i);
      return;
    }
    thread_local std::vector<std::uint32_t> found;
    found.clear();
    tree->met_by(ray, found);
    for (const std::uint32_t element : found) visit(element);
  }
  template <class Visit>
  void for_each_around(const Vec3& point, const Visit& visit) const {
    if (!tree) {
      std::ranges::for_each(elements, visit);
      return;
    }
    tree->any_around(point, [&](std::uint32_t element) {
      visit(elements[element]);
      return false;
    });
  }
  /// Keeps them in order. What is added stands before what is at the same place.
  void add_changes(const Ray& ray, std::uint32_t element, std::vector<Change>& changes) const {
    const std::optional<Interval> field = elements[element].crossed(ray);
    if (!field) return;
    const auto before = [](const Change& change, double at) { return change.at < at; };
    const auto enters = changes.insert(std::lower_bound(changes.begin(), changes.end(), field->begin, before),
                                       {field->begin, element, true});
    const auto after = enters + 1;
    changes.insert(std::lower_bound(after, changes.end(), field->end, before), {field->end, element, false});
  }
};

}  // namespace

ShapePtr make_blob(const BlobParameters& parameters) {
  return std::make_shared<Placed<Blob>>(Blob(parameters), Transform());
}

}  // namespace firstlight::render
