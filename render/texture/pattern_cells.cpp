// Patterns of random cells: cells, crackle, facets.

#include "render/math/lattice_random.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/pattern_cells.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"
#include "render/math/noise-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#ifndef FIRSTLIGHT_RENDER_TEXTURE_PATTERN_CELLS
#define FIRSTLIGHT_RENDER_TEXTURE_PATTERN_CELLS
namespace firstlight::render {
namespace {

/// Points this little above a border belong to the cell below it, of cells this little below to that above. [POV-Ray 3.7]
constexpr double kBorder = 1e-10;

Vec3 corner_below(const Vec3& p) {
  return {std::floor(p.x - kBorder), std::floor(p.y - kBorder), std::floor(p.z - kBorder)};
}

/// Cells in which the random point that is nearest to a point in the middle one may be: at most one of the steps is 2.
/// The middle one and those that touch it come first.
constexpr std::size_t kNear = 81;
constexpr std::size_t kRoom = 88, kBehindTouching = 32;  // whole numbers of vectors; 27 touch it
struct NearCells {
  struct Cell {
    Vec3 step;
    std::size_t place;  ///< among NearPoints
  };
  std::array<Cell, kNear> cells;        ///< in the order of their numbers, which decides between equal distances
  std::array<double, kRoom> number_at;  ///< of the cell at a place; infinite: none

  NearCells() {
    number_at.fill(INFINITY);
    std::size_t number = 0, near = 0, far = kBehindTouching;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          const int far_steps = (std::abs(x) == 2) + (std::abs(y) == 2) + (std::abs(z) == 2);
          if (far_steps > 1) continue;
          const std::size_t place = far_steps == 0 ? near++ : far++;
          number_at[place] = static_cast<double>(number);
          cells[number++] = {Vec3(x, y, z), place};
        }
      }
    }
  }
  static const NearCells& get() {
    static const NearCells cells;
    return cells;
  }
};

/// Points of one cell and those about it; elsewhere some that are near to nothing.
struct NearPoints {
  std::array<std::array<double, kRoom>, 3> at;
  Vec3 corner{0.0};
  bool is_known = false;
};

/// Neighbours on a surface, and along a ray, often are in one cell; so what was found for some cells is kept, by thread.
const NearPoints& points_about(const Vec3& corner) {
  constexpr std::size_t kKept = 32;
  thread_local std::array<NearPoints, kKept> kept;
  NearPoints& near = kept[cell_hash(corner.x, corner.y, corner.z) % kKept];
  if (near.is_known && near.corner == corner) return near;
  for (std::array<double, kRoom>& axis : near.at) axis.fill(INFINITY);
  for (const NearCells::Cell& cell : NearCells::get().cells) {
    const Vec3 point = point_in_cell(corner + cell.step);
    for (std::size_t axis = 0; axis < 3; ++axis) near.at[axis][cell.place] = point[static_cast<int>(axis)];
  }
  near.corner = corner;
  near.is_known = true;
  return near;
}

/// Whether points of cells that do not touch the middle one, which are at least 1 away along an axis, are further than
/// what has this sum of distances along the axes, raised to the metric.
bool is_nearer_than_others(double sum, const Vec3& place, double metric) {
  constexpr double kFarOut = 1e6, kHighestMetric = 100.0;  // rounding counts beyond
  const double out = std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
  return sum < 0.9 && out < kFarOut && metric > 0.0 && metric < kHighestMetric;
}

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// |x|^m + |y|^m + |z|^m.
template <class L>
HWY_INLINE L metric_sum(const Vec3Of<L>& v, double m) {
  if (m == 2.0) return dot(v, v);
  if (m == 1.0) return abs(v.x) + abs(v.y) + abs(v.z);
  return power(abs(v.x), L(m)) + power(abs(v.y), L(m)) + power(abs(v.z), L(m));
}
/// Its root.
template <class L>
HWY_INLINE L metric_root(const L& sum, double m) {
  if (m == 2.0) return sqrt(sum);
  return m == 1.0 ? sum : power(sum, L(1.0 / m));
}

template <class L>
HWY_INLINE Vec3Of<L> near_points(const NearPoints& points, std::size_t i) {
  return {L::load(&points.at[0][i]), L::load(&points.at[1][i]), L::load(&points.at[2][i])};
}

/// The least three numbers, in order.
struct Least {
  double of[3];
};
/// Those of two times three. The third is the least of what is never below two others.
HWY_INLINE Least least_of(const Least& a, const Least& b) {
  const auto low = [](double x, double y) { return y < x ? y : x; };
  const auto high = [](double x, double y) { return x < y ? y : x; };
  return {{low(a.of[0], b.of[0]), low(high(a.of[0], b.of[0]), low(a.of[1], b.of[1])),
           low(low(a.of[2], b.of[2]), low(high(a.of[1], b.of[0]), high(a.of[0], b.of[1])))}};
}

/// The three least of each lane become those of all.
template <class L>
HWY_INLINE Least least_of_lanes(const L (&least)[3]) {
  double sums[3][L::kCount];
  for (std::size_t k = 0; k < 3; ++k) least[k].store(sums[k]);
  Least all[L::kCount];
  for (std::size_t lane = 0; lane < L::kCount; ++lane) all[lane] = {{sums[0][lane], sums[1][lane], sums[2][lane]}};
  for (std::size_t half = L::kCount / 2; half != 0; half /= 2) {
    for (std::size_t lane = 0; lane < half; ++lane) all[lane] = least_of(all[lane], all[lane + half]);
  }
  return all[0];
}

/// Finds the three least distances from a place to points about it, before their root is taken. A distance that is no
/// number counts as far.
template <class L>
HWY_INLINE Least least_sums(const Vec3& place, double metric, const NearPoints& points) {
  const Vec3Of<L> p = everywhere<L>(place);
  L least[3] = {L(kInfinite), L(kInfinite), L(kInfinite)};
  for (std::size_t i = 0; i < kRoom; i += L::kCount) {
    if (i == kBehindTouching) {
      const Least touching = least_of_lanes(least);
      if (is_nearer_than_others(touching.of[2], place, metric)) return touching;
    }
    const L sum = metric_sum(near_points<L>(points, i) - p, metric);
    least[2] = min(least[2], max(sum, least[1]));
    least[1] = min(least[1], max(sum, least[0]));
    least[0] = min(least[0], sum);
  }
  return least_of_lanes(least);
}

/// The place of the nearest point; of several that with the lowest number. `signed_steps`: with metric 1 steps are not
/// taken without their signs.
template <class L>
HWY_INLINE std::size_t nearest_of(const Vec3& place, double metric, bool signed_steps, const NearPoints& points) {
  const NearCells& cells = NearCells::get();
  const Vec3Of<L> p = everywhere<L>(place);
  L least = kInfinite, number = 0.0;
  for (std::size_t i = 0; i < kRoom; i += L::kCount) {
    const Vec3Of<L> way = near_points<L>(points, i) - p;
    const L sum = signed_steps && metric == 1.0 ? way.x + way.y + way.z : metric_sum(way, metric);
    const L own = L::load(&cells.number_at[i]);
    const auto nearer = (sum < least) | ((sum == least) & (sum < kInfinite) & (own < number));
    number = select(nearer, own, number);
    least = min(least, sum);
  }
  double sums[L::kCount], numbers[L::kCount];
  least.store(sums);
  number.store(numbers);
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < L::kCount; ++lane) {
    const bool is_tie = sums[lane] == sums[best] && sums[lane] < kInfinite;
    if (sums[lane] < sums[best] || (is_tie && numbers[lane] < numbers[best])) best = lane;
  }
  return cells.cells[static_cast<std::size_t>(numbers[best])].place;
}

Vec3 nearest_point(const Vec3& place, double metric, bool signed_steps) {
  const NearPoints& points = points_about(corner_below(place));
  const std::size_t i = nearest_of<Lanes>(place, metric, signed_steps, points);
  return {points.at[0][i], points.at[1][i], points.at[2][i]};
}

/// The noise at the nearest of random points.
void solid_crackle(const CrackleParameters& parameters, int generator, const Columns3<double>& at, std::size_t count,
                   Column<double>& values) {
  Columns3<double> nearest;
  for (std::size_t i = 0; i < count; ++i) nearest.set(i, nearest_point(at.vector(i), parameters.metric, false));
  for (std::size_t i = 0; i < count; i += Lanes::kCount) store(noise(load3<Lanes>(nearest, i), generator), values, i);
}

/// The distances to the three nearest of random points, weighted. [S. Worley 1996, "A cellular texture basis function"]
void crackle_values(const CrackleParameters& parameters, int generator, const Columns3<double>& at, std::size_t count,
                    Column<double>& values) {
  if (parameters.solid) return solid_crackle(parameters, generator, at, count, values);
  const double m = parameters.metric;
  Columns3<double> sums;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = at.vector(i);
    const Least least = least_sums<Lanes>(place, m, points_about(corner_below(place)));
    sums.set(i, Vec3(least.of[0], least.of[1], least.of[2]));
  }
  Lanes more = 0.0;
  if (parameters.offset != 0.0) {
    const Lanes offset = parameters.offset;
    more = m == 2.0 ? offset * offset : m == 1.0 ? offset : power(offset, Lanes(m));
  }
  const Vec3& form = parameters.form;
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Vec3Of<Lanes> least = load3<Lanes>(sums, i);
    const Lanes sum = form.x * metric_root(least.x + more, m) + form.y * metric_root(least.y + more, m) +
                      form.z * metric_root(least.z + more, m);
    store(max(min(sum, 1.0), 0.0), values, i);
  }
}

template <class L>
HWY_INLINE Vec3Of<L> unit_or_0(const Vec3Of<L>& v) {
  const L size = length(v);
  const Vec3Of<L> zero = {L(0.0), L(0.0), L(0.0)};
  return select(size != 0.0, v / size, zero);
}

/// To the nearest of random points; with `coords` by the noise there.
void facet_tilts(const FacetsParameters& parameters, const Columns3<double>& at, std::size_t count,
                 Columns3<double>& normals) {
  constexpr double kSmallest = 1e-6;
  const double scale = parameters.size < kSmallest ? 1.0 / kSmallest : 1.0 / parameters.size;
  const bool by_place = parameters.coords != 0.0;
  Columns3<double> facets;
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Vec3Of<Lanes> normal = unit_or_0(load3<Lanes>(normals, i));
    store3(normal, normals, i);
    store3((by_place ? load3<Lanes>(at, i) : normal) * Lanes(scale), facets, i);
  }
  for (std::size_t i = 0; i < count; ++i) facets.set(i, nearest_point(facets.vector(i), parameters.metric, true));
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    Vec3Of<Lanes> facet = load3<Lanes>(facets, i);
    if (by_place) {
      const Vec3Of<Lanes> normal = load3<Lanes>(normals, i), shove = dnoise(facet);
      facet = normal + (shove - normal * dot(shove, normal)) * Lanes(parameters.coords);
    }
    store3(facet, normals, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(crackle_values);
HWY_EXPORT(facet_tilts);

class Crackle final : public Pattern {
 public:
  Crackle(const CrackleParameters& parameters, int noise_generator)
      : parameters_(parameters), generator_(noise_generator) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    HWY_DYNAMIC_DISPATCH(crackle_values)(parameters_, generator_, at, points.size, values);
  }

 private:
  CrackleParameters parameters_;
  int generator_;
};

/// Turns normals to the nearest of random directions, or, with `coords`, alike in each of random cells.
class Facets final : public Pattern {
 public:
  explicit Facets(const FacetsParameters& parameters) : parameters_(parameters) {}

  void values(const Columns3<double>&, const SurfacePoints& points, Column<double>& values) const override {
    std::fill_n(values.at.begin(), points.size, 0.0);
  }
  bool has_tilt() const override { return true; }
  void tilt(const Tilting&, const Columns3<double>& at, const SurfacePoints& points,
            Columns3<double>& normals) const override {
    HWY_DYNAMIC_DISPATCH(facet_tilts)(parameters_, at, points.size, normals);
  }

 private:
  FacetsParameters parameters_;
};

}  // namespace

PatternPtr pattern::make_cells(const PatternRequest&) {
  return make_field([](const Vec3& p) {
    return table_random(cell_hash(std::floor(p.x + kBorder), std::floor(p.y + kBorder), std::floor(p.z + kBorder)));
  });
}

PatternPtr pattern::make_crackle(const PatternRequest& request) {
  return std::make_shared<Crackle>(request.get<CrackleParameters>(), request.noise_generator);
}

PatternPtr pattern::make_facets(const PatternRequest& request) {
  return std::make_shared<Facets>(request.get<FacetsParameters>());
}

}  // namespace firstlight::render
#endif
