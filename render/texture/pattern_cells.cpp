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
#include <bit>
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
constexpr std::size_t kNear = 81;
const std::array<Vec3, kNear>& near_cells() {
  static const std::array<Vec3, kNear> cells = [] {
    std::array<Vec3, kNear> result;
    std::size_t count = 0;
    for (int x = -2; x <= 2; ++x) {
      for (int y = -2; y <= 2; ++y) {
        for (int z = -2; z <= 2; ++z) {
          if ((std::abs(x) == 2) + (std::abs(y) == 2) + (std::abs(z) == 2) <= 1) result[count++] = Vec3(x, y, z);
        }
      }
    }
    return result;
  }();
  return cells;
}

/// Points of one cell and those about it.
struct NearPoints {
  std::array<std::array<double, kNear>, 3> at;
  Vec3 corner{0.0};
  bool is_known = false;
};

/// Neighbours on a surface, and along a ray, often are in one cell; so what was found for some cells is kept, by thread.
const NearPoints& points_about(const Vec3& corner) {
  constexpr std::size_t kKept = 32;
  thread_local std::array<NearPoints, kKept> kept;
  NearPoints& near = kept[cell_hash(corner.x, corner.y, corner.z) % kKept];
  if (near.is_known && near.corner == corner) return near;
  for (std::size_t i = 0; i < kNear; ++i) {
    const Vec3 point = point_in_cell(corner + near_cells()[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) near.at[axis][i] = point[static_cast<int>(axis)];
  }
  near.corner = corner;
  near.is_known = true;
  return near;
}

/// Calls visit(points, members, count) for each cell that any of the first `count` places lies in: its random points, and
/// which of the places lie there.
template <class Visit>
inline void for_each_cell(const Columns3<double>& places, std::size_t count, const Visit& visit) {
  std::array<Vec3, kRaysAtOnce> corners;
  std::uint64_t left = count == 0 ? 0 : ~std::uint64_t{0} >> (kRaysAtOnce - count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = corner_below(places.vector(i));
  while (left != 0) {
    const Vec3 corner = corners[static_cast<std::size_t>(std::countr_zero(left))];
    std::array<std::uint8_t, kRaysAtOnce> members;
    std::size_t size = 0;
    for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      // One whose corner is no number is alone.
      if (corners[i] != corner && size != 0) continue;
      members[size++] = static_cast<std::uint8_t>(i);
      left &= ~(std::uint64_t{1} << i);
    }
    visit(points_about(corner), members, size);
  }
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
HWY_INLINE Vec3Of<L> near_point(const NearPoints& points, std::size_t i) {
  return {L(points.at[0][i]), L(points.at[1][i]), L(points.at[2][i])};
}
/// The points of numbers i, which are whole.
template <class L>
HWY_INLINE Vec3Of<L> near_points(const NearPoints& points, const L& i) {
  double number[L::kCount], x[L::kCount], y[L::kCount], z[L::kCount];
  i.store(number);
  for (std::size_t lane = 0; lane < L::kCount; ++lane) {
    const auto k = static_cast<std::size_t>(number[lane]);
    x[lane] = points.at[0][k];
    y[lane] = points.at[1][k];
    z[lane] = points.at[2][k];
  }
  return {L::load(x), L::load(y), L::load(z)};
}

/// The distances to the three nearest of random points, weighted. [S. Worley 1996, "A cellular texture basis function"]
template <class L>
HWY_INLINE L crackle(const CrackleParameters& parameters, int generator, const Vec3Of<L>& p, const NearPoints& points) {
  const double m = parameters.metric;
  L least[3] = {L(kInfinite), L(kInfinite), L(kInfinite)};
  L nearest = 0.0;
  for (std::size_t i = 0; i < kNear; ++i) {
    const L sum = metric_sum(near_point<L>(points, i) - p, m);
    if (parameters.solid) nearest = select(sum < least[0], L(static_cast<double>(i)), nearest);
    // What is no number changes none of them.
    least[2] = min(least[2], max(sum, least[1]));
    least[1] = min(least[1], max(sum, least[0]));
    least[0] = min(least[0], sum);
  }
  if (parameters.solid) return noise(near_points(points, nearest), generator);
  L more = 0.0;
  if (parameters.offset != 0.0) {
    const L offset = parameters.offset;
    more = m == 2.0 ? offset * offset : m == 1.0 ? offset : power(offset, L(m));
  }
  const Vec3& form = parameters.form;
  const L sum = form.x * metric_root(least[0] + more, m) + form.y * metric_root(least[1] + more, m) +
                form.z * metric_root(least[2] + more, m);
  return max(min(sum, 1.0), 0.0);
}

void crackle_values(const CrackleParameters& parameters, int generator, const Columns3<double>& at, std::size_t count,
                    Column<double>& values) {
  for_each_cell(at, count, [&](const NearPoints& points, const auto& members, std::size_t size) HWY_ATTR {
    Columns3<double> picked;
    Column<double> found;
    for (std::size_t k = 0; k < size; ++k) picked.set(k, at.vector(members[k]));
    for (std::size_t k = 0; k < size; k += Lanes::kCount) {
      store(crackle(parameters, generator, load3<Lanes>(picked, k), points), found, k);
    }
    for (std::size_t k = 0; k < size; ++k) values[members[k]] = found[k];
  });
}

/// The number of the nearest of the points. With metric 1 the steps are not taken without their signs. [POV-Ray 3.7]
template <class L>
HWY_INLINE L nearest_of(const Vec3Of<L>& place, double metric, const NearPoints& points) {
  L nearest = 0.0, least = kInfinite;
  for (std::size_t i = 0; i < kNear; ++i) {
    const Vec3Of<L> way = near_point<L>(points, i) - place;
    const L sum = metric == 1.0 ? way.x + way.y + way.z : metric_sum(way, metric);
    nearest = select(sum < least, L(static_cast<double>(i)), nearest);
    least = min(least, sum);
  }
  return nearest;
}

template <class L>
HWY_INLINE Vec3Of<L> unit_or_0(const Vec3Of<L>& v) {
  const L size = length(v);
  const Vec3Of<L> zero = {L(0.0), L(0.0), L(0.0)};
  return select(size != 0.0, v / size, zero);
}

void facet_tilts(const FacetsParameters& parameters, const Columns3<double>& at, std::size_t count,
                 Columns3<double>& normals) {
  constexpr double kSmallest = 1e-6;
  const double scale = parameters.size < kSmallest ? 1.0 / kSmallest : 1.0 / parameters.size;
  Columns3<double> places;
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Vec3Of<Lanes> normal = unit_or_0(load3<Lanes>(normals, i));
    store3(normal, normals, i);
    store3((parameters.coords != 0.0 ? load3<Lanes>(at, i) : normal) * Lanes(scale), places, i);
  }
  for_each_cell(places, count, [&](const NearPoints& points, const auto& members, std::size_t size) HWY_ATTR {
    Columns3<double> picked, found, picked_normals;
    for (std::size_t k = 0; k < size; ++k) {
      picked.set(k, places.vector(members[k]));
      picked_normals.set(k, normals.vector(members[k]));
    }
    for (std::size_t k = 0; k < size; k += Lanes::kCount) {
      Vec3Of<Lanes> facet = near_points(points, nearest_of(load3<Lanes>(picked, k), parameters.metric, points));
      if (parameters.coords != 0.0) {
        const Vec3Of<Lanes> normal = load3<Lanes>(picked_normals, k), shove = dnoise(facet);
        facet = normal + (shove - normal * dot(shove, normal)) * Lanes(parameters.coords);
      }
      store3(facet, found, k);
    }
    for (std::size_t k = 0; k < size; ++k) normals.set(members[k], found.vector(k));
  });
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
