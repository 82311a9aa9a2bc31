#include "render/shape/isosurface.h"

#include "render/math/random.h"
#include "render/shape/placed.h"
#include "render/shape/root_search.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

// As in POV-Ray, in units of the accuracy: how far behind a crossing the next one is looked for, and the field below
// which, over the gradient, a ray begins on the surface.
constexpr double kSkip = 5.0;
constexpr double kOnSurface = 4.0;
constexpr std::uint64_t kProbes = 2000;
constexpr double kProbeInstructions = 1e8;  ///< of the function, of all probes together

/// Takes crossings that nobody wants.
struct Nothing {
  void add(double, std::uint32_t = 0) {}
  bool is_enough() const { return false; }
  double high() const { return kBoundless; }
};

struct Isosurface {
  static constexpr bool kIsLarge = true;

  IsosurfaceParameters p;

  explicit Isosurface(const IsosurfaceParameters& parameters) : p(parameters) {
    if (p.evaluate) find_gradient();
  }

  void meet(const Ray& ray, Met& met) const {
    FieldGradient gradient = start_gradient();
    meet(ray, met, gradient);
  }
  bool inside(const Vec3& point, bool inverted) const {
    if (!holds(p.container, point)) return inverted;
    Evaluation evaluation = start();
    return (RayField(*p.function, p.threshold, {point, Vec3(0.0)}, evaluation).at(0.0) > 0.0) == inverted;
  }
  Vec3 normal(const Vec3& point, const Crossing& at) const {
    if (at.face != 0) {
      Vec3 side(0.0);
      side[static_cast<int>((at.face - 1) / 2)] = at.face % 2 == 1 ? -1.0 : 1.0;
      return side;
    }
    if (const auto* sphere = std::get_if<ContainerSphere>(&p.container)) {
      const Vec3 from_center = point - sphere->center;
      if (std::abs(from_center.length() - sphere->radius) < kEpsilon) return from_center;
    }
    std::array<FieldColumn, 3> points;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double here = point[static_cast<int>(axis)];
      std::fill_n(points[axis].begin(), 4, here);
      points[axis][axis + 1] = here + p.accuracy;
    }
    FieldColumn values;
    Evaluation evaluation = start();
    evaluate_field(*p.function, points, 4, values, evaluation);
    const Vec3 n(values[1] - values[0], values[2] - values[0], values[3] - values[0]);
    const double length = n.length();
    return length > 0.0 && std::isfinite(length) ? n / length : Vec3(1.0, 0.0, 0.0);
  }
  Box3 bounds() const { return bounds_of(p.container); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  Evaluation start() const { return {.noise_generator = p.noise_generator}; }
  FieldGradient start_gradient() const { return {p.max_gradient, p.evaluate ? &*p.evaluate : nullptr}; }

  /// POV-Ray carries what a ray teaches of the gradient on to the next. Here rays that are the same for every picture
  /// teach it, before the first is traced: no ray depends on another.
  void find_gradient() {
    const Box3 box = bounds();
    const Vec3 size = box.size();
    Nothing nothing;
    double left = kProbeInstructions / static_cast<double>(p.function->cost());
    for (std::uint64_t i = 0; i < kProbes && left > 0.0; ++i) {
      const HashedDraws draw(Vec3(static_cast<double>(i), 0.0, 0.0));
      const Vec3 from = box.min + size * Vec3(draw[0], draw[1], draw[2]);
      const Vec3 to = box.min + size * Vec3(draw[3], draw[4], draw[5]);
      const Vec3 direction = unit(to - from);
      const Ray ray{from - direction * size.length(), direction};
      FieldGradient gradient = start_gradient();
      left -= meet(ray, nothing, gradient);
      if (gradient.most < kBoundless) p.max_gradient = std::max(p.max_gradient, gradient.most);
    }
  }

  /// Returns how often the function was asked, but for a few times.
  template <class Taker>
  int meet(const Ray& ray, Taker& met, FieldGradient& gradient) const {
    const std::optional<ContainedPart> part = contained_part(p.container, ray);
    if (!part) return 0;
    double begin = std::max(part->begin, 0.0);
    const double end = std::min(part->end, kBoundingHuge);
    if (begin > met.high()) return 0;
    Evaluation evaluation = start();
    RayField field(*p.function, p.threshold, ray, evaluation);
    bool enters_cap = false;
    bool leaves_cap = false;
    if (!p.open && begin > p.accuracy) {
      enters_cap = field.at(begin) < 0.0;
      if (enters_cap) field.turn();
    } else if (!p.open) {
      leaves_cap = field.at(end) < 0.0;
      if (field.at(begin) < gradient.most * p.accuracy * kOnSurface) begin = start_within(field);
    } else if (begin < p.accuracy && std::abs(field.at(begin)) < gradient.most * p.accuracy * kOnSurface) {
      begin = start_within(field);
    }
    begin = std::min(begin, end);
    if (end - begin < p.accuracy) return 0;
    if (enters_cap) met.add(begin, part->begin_face);

    int evaluations = 0;
    RootSearch search(field, ray.direction.length(), p.accuracy, gradient);
    for (int trace = enters_cap ? 1 : 0; trace < p.max_trace && !met.is_enough(); ++trace) {
      double at_begin = field.at(begin);
      if (p.open && at_begin < 0.0) {
        field.turn();
        at_begin = -at_begin;
      }
      const std::optional<double> root = search.first(begin, at_begin, end, field.at(end), met.high());
      evaluations += search.evaluations();
      if (!root) break;
      met.add(*root);
      begin = *root + p.accuracy * kSkip;
      if (end - begin < p.accuracy) break;
      field.turn();
    }
    gradient = search.gradient();
    if (leaves_cap) met.add(part->end, part->end_face);
    return evaluations;
  }
  /// The ray's beginning, away from the surface that it begins on or in.
  double start_within(RayField& field) const {
    const double begin = p.accuracy * kSkip;
    if (field.at(begin) < 0.0) field.turn();
    return begin;
  }
};

}  // namespace

ShapePtr make_isosurface(const IsosurfaceParameters& parameters) {
  return std::make_shared<Placed<Isosurface>>(Isosurface(parameters), Transform());
}

}  // namespace firstlight::render
