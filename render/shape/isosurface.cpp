#include "render/shape/isosurface.h"

#include "render/math/random.h"
#include "render/shape/placed.h"
#include "render/shape/root_search.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace firstlight::render {
namespace {

// As in POV-Ray, in units of the accuracy: how far behind a crossing the next one is looked for, and the field below
// which, over the gradient, a ray begins on the surface.
constexpr double kSkip = 5.0;
constexpr double kOnSurface = 4.0;
constexpr std::uint64_t kProbes = 2000;
constexpr double kProbeInstructions = 1e8;  ///< of the function, of all probes together

/// Calls visit(i) for each bit, the lowest first.
template <class Visit>
void for_each_bit(std::uint64_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Takes crossings that nobody wants.
struct Nothing {
  void add(std::size_t, double, std::uint32_t = 0) {}
  bool is_enough(std::size_t) const { return false; }
  double high(std::size_t) const { return kBoundless; }
};

/// Takes those of a single ray.
struct OneRay {
  Met& met;
  void add(std::size_t, double depth, std::uint32_t face = 0) { met.add(depth, face); }
  bool is_enough(std::size_t) const { return met.is_enough(); }
  double high(std::size_t) const { return met.high(); }
};

/// Takes those of a block.
class IntoSlots {
 public:
  IntoSlots(const RaysAndPlace& asked, Slots& slots) : asked_(asked), lists_(asked.shape, slots, true) {}

  void add(std::size_t ray, double depth, std::uint32_t face = 0) {
    lists_.add(ray, depth, face, {});
    if (asked_.nearest_only != nullptr && depth > asked_.nearest_only->low[ray]) enough_ |= std::uint64_t{1} << ray;
  }
  bool is_enough(std::size_t ray) const { return (enough_ >> ray & 1u) != 0; }
  double high(std::size_t ray) const {
    return asked_.nearest_only != nullptr ? asked_.nearest_only->high[ray] : kBoundless;
  }

 private:
  const RaysAndPlace& asked_;
  SlotLists lists_;
  std::uint64_t enough_ = 0;
};

struct Isosurface {
  static constexpr bool kIsLarge = true;

  IsosurfaceParameters p;

  explicit Isosurface(const IsosurfaceParameters& parameters) : p(parameters) {
    if (p.evaluate) find_gradient();
  }

  void meet(const Ray& ray, Met& met) const {
    OneRay taker{met};
    meet({p.container, Transform(), alone(ray), 1}, taker);
  }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const {
    const ContainedRays contained(p.container, asked.transform, asked.rays, asked.who);
    if (contained.met == 0) return;
    IntoSlots taker(asked, slots);
    meet(contained, taker);
  }
  bool inside(const Vec3& point, bool inverted) const {
    return inside_block(Transform(), inverted, {alone(point.x), alone(point.y), alone(point.z)}, 1) != 0;
  }
  std::uint64_t inside_block(const Transform& transform, bool inverted, const Columns3<double>& points,
                             std::uint64_t who) const {
    RayColumns places;  // depth 0 of rays that go nowhere
    const std::uint64_t held = held_points(p.container, transform, points, who, places.origin);
    if (held == 0) return inverted ? who : 0;
    for (Column<double>& along : places.direction.of) along.at.fill(0.0);
    Column<double> depth;
    Column<double> value;
    depth.at.fill(0.0);
    fields(places).at(held, depth, value);
    std::uint64_t inside = 0;
    for_each_bit(held, [&](std::size_t i) {
      if (!(value[i] > 0.0)) inside |= std::uint64_t{1} << i;
    });
    return inverted ? who & ~inside : inside;
  }
  Vec3 normal(const Vec3& point, const Crossing& at) const {
    SurfacePlaces places;
    places.point.set(0, point);
    places.crossing[0] = &at;
    Columns3<double> found;
    found.set(0, Vec3(0.0));
    normals(places, 0, 1, found);
    return found.vector(0);
  }
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const {
    // Differences of the field: at each point, and a little further along each axis.
    std::array<std::array<double, 4 * kRaysAtOnce>, 3> points;
    std::array<double, 4 * kRaysAtOnce> values;
    std::size_t count = 0;
    std::uint64_t open = 0;
    for (std::size_t i = first; i < end; ++i) {
      const Vec3 point = places.point.vector(i);
      if (const std::optional<Vec3> normal = container_normal(point, *places.crossing[i])) {
        out.set(i, *normal);
        continue;
      }
      open |= std::uint64_t{1} << i;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double here = point[static_cast<int>(axis)];
        std::fill_n(points[axis].begin() + static_cast<std::ptrdiff_t>(count), 4, here);
        points[axis][count + axis + 1] = here + p.accuracy;
      }
      count += 4;
    }
    fields({}).evaluate({points[0].data(), points[1].data(), points[2].data()}, count, values.data());
    count = 0;
    for_each_bit(open, [&](std::size_t i) {
      const double* at = values.data() + count;
      const Vec3 n(at[1] - at[0], at[2] - at[0], at[3] - at[0]);
      const double length = n.length();
      out.set(i, length > 0.0 && std::isfinite(length) ? n / length : Vec3(1.0, 0.0, 0.0));
      count += 4;
    });
  }
  Box3 bounds() const { return bounds_of(p.container); }
  Box3 inside_bounds() const { return bounds(); }

 private:
  RayFields fields(const RayColumns& rays) const { return {*p.function, p.threshold, rays, p.noise_generator}; }

  /// Normal of the container's own surface.
  std::optional<Vec3> container_normal(const Vec3& point, const Crossing& at) const {
    if (at.face != 0) {
      Vec3 side(0.0);
      side[static_cast<int>((at.face - 1) / 2)] = at.face % 2 == 1 ? -1.0 : 1.0;
      return side;
    }
    if (const auto* sphere = std::get_if<ContainerSphere>(&p.container)) {
      const Vec3 from_center = point - sphere->center;
      if (std::abs(from_center.length() - sphere->radius) < kEpsilon) return from_center;
    }
    return std::nullopt;
  }

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
      const Learnt learnt = meet({p.container, Transform(), alone(ray), 1}, nothing);
      left -= learnt.evaluations;
      if (learnt.gradient < kBoundless) p.max_gradient = std::max(p.max_gradient, learnt.gradient);
    }
  }
  /// Gradient as the first ray has learnt it, and how often the function was asked for it.
  struct Learnt {
    double gradient;
    int evaluations;
  };

  template <class Taker>
  Learnt meet(const ContainedRays& contained, Taker& taker) const {
    Meeting<Taker> meeting(*this, contained, taker);
    meeting.run();
    return meeting.learnt();
  }

  /// Some rays that meet the surface.
  template <class Taker>
  class Meeting {
   public:
    Meeting(const Isosurface& surface, const ContainedRays& contained, Taker& taker)
        : p_(surface.p), contained_(contained), taker_(taker), fields_(surface.fields(contained.rays)) {
      part_.gradient[0] = p_.max_gradient;
    }

    void run() {
      const std::uint64_t open = begin();
      if (p_.evaluate) {
        LearningSearch search(fields_, p_.accuracy, *p_.evaluate);
        find_all(open, search);
        evaluations_ = search.evaluations();
      } else {
        RootSearch search(fields_, p_.accuracy);
        find_all(open, search);
      }
      for_each_bit(leaves_cap_, [&](std::size_t i) { taker_.add(i, contained_.end[i], face(contained_.end_face[i])); });
    }
    Learnt learnt() const { return {part_.gradient[0], evaluations_}; }

   private:
    /// Finds the parts of the rays that are to be searched, and what they meet of the container's surface first.
    std::uint64_t begin() {
      std::uint64_t met = 0;
      for_each_bit(contained_.met, [&](std::size_t i) {
        part_.begin[i] = std::max(contained_.begin[i], 0.0);
        if (part_.begin[i] > taker_.high(i)) return;
        met |= std::uint64_t{1} << i;
        part_.end[i] = std::min(contained_.end[i], kBoundingHuge);
        part_.high[i] = taker_.high(i);
        part_.speed[i] = contained_.rays.direction.vector(i).length();
        part_.gradient[i] = p_.max_gradient;
      });
      fields_.at(met, part_.begin, part_.at_begin);
      fields_.at(met, part_.end, part_.at_end);
      std::uint64_t enters_cap = 0;
      std::uint64_t within = 0;  // these begin on the surface or in the solid
      for_each_bit(met, [&](std::size_t i) {
        const std::uint64_t bit = std::uint64_t{1} << i;
        const double value = part_.at_begin[i];
        const double on_surface = p_.max_gradient * p_.accuracy * kOnSurface;
        if (!p_.open && part_.begin[i] > p_.accuracy) {
          if (value < 0.0) enters_cap |= bit;
        } else if (!p_.open) {
          if (part_.at_end[i] < 0.0) leaves_cap_ |= bit;
          if (value < on_surface) within |= bit;
        } else if (part_.begin[i] < p_.accuracy && std::abs(value) < on_surface) {
          within |= bit;
        }
        if ((within & bit) != 0) part_.begin[i] = p_.accuracy * kSkip;
      });
      fields_.at(within, part_.begin, part_.at_begin);
      std::uint64_t open = 0;
      for_each_bit(met, [&](std::size_t i) {
        const std::uint64_t bit = std::uint64_t{1} << i;
        if ((enters_cap & bit) != 0 || ((within & bit) != 0 && part_.at_begin[i] < 0.0)) turn(i);
        if (part_.end[i] - part_.begin[i] < p_.accuracy) {
          leaves_cap_ &= ~bit;
          return;
        }
        if ((enters_cap & bit) != 0) taker_.add(i, part_.begin[i], face(contained_.begin_face[i]));
        traces_[i] = (enters_cap & bit) != 0 ? 1 : 0;
        if (goes_on(i)) open |= bit;
      });
      return open;
    }
    static std::uint32_t face(double number) { return static_cast<std::uint32_t>(number); }
    bool goes_on(std::size_t i) const { return traces_[i] < p_.max_trace && !taker_.is_enough(i); }
    void turn(std::size_t i) {
      fields_.turn(i);
      part_.at_begin[i] = -part_.at_begin[i];
      part_.at_end[i] = -part_.at_end[i];
    }

    /// Adds the roots of the rays in `open`, one of each at a time.
    template <class Search>
    void find_all(std::uint64_t open, Search& search) {
      Column<double> root;
      while (open != 0) {
        if (p_.open) {
          for_each_bit(open, [&](std::size_t i) {
            if (part_.at_begin[i] < 0.0) turn(i);
          });
        }
        const std::uint64_t found = search.first(open, part_, root);
        open = 0;
        for_each_bit(found, [&](std::size_t i) {
          taker_.add(i, root[i]);
          part_.begin[i] = root[i] + p_.accuracy * kSkip;
          ++traces_[i];
          if (part_.end[i] - part_.begin[i] < p_.accuracy || !goes_on(i)) return;
          turn(i);
          open |= std::uint64_t{1} << i;
        });
        fields_.at(open, part_.begin, part_.at_begin);
      }
    }

    const IsosurfaceParameters& p_;
    const ContainedRays& contained_;
    Taker& taker_;
    RayFields fields_;
    SearchedPart part_;
    std::array<int, kRaysAtOnce> traces_;
    std::uint64_t leaves_cap_ = 0;
    int evaluations_ = 0;
  };
};

}  // namespace

ShapePtr make_isosurface(const IsosurfaceParameters& parameters) {
  return std::make_shared<Placed<Isosurface>>(Isosurface(parameters), Transform());
}

}  // namespace firstlight::render
