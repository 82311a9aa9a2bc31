// Patterns of random cells: cells, crackle, facets.

#include "render/math/lattice_random.h"
#include "render/math/noise.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

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

  Vec3 operator[](std::size_t i) const { return {at[0][i], at[1][i], at[2][i]}; }
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

/// |x|^m + |y|^m + |z|^m, and its root.
struct Metric {
  double power;

  double sum(const Vec3& v) const {
    if (power == 2.0) return v.x * v.x + v.y * v.y + v.z * v.z;
    if (power == 1.0) return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    return std::pow(std::abs(v.x), power) + std::pow(std::abs(v.y), power) + std::pow(std::abs(v.z), power);
  }
  void sums(const Vec3& from, const NearPoints& points, std::array<double, kNear>& sums) const {
    if (power != 2.0) {
      for (std::size_t i = 0; i < kNear; ++i) sums[i] = sum(points[i] - from);
      return;
    }
    for (std::size_t i = 0; i < kNear; ++i) {
      const double x = points.at[0][i] - from.x;
      const double y = points.at[1][i] - from.y;
      const double z = points.at[2][i] - from.z;
      sums[i] = x * x + y * y + z * z;
    }
  }
  double root(double sum) const {
    if (power == 2.0) return std::sqrt(sum);
    return power == 1.0 ? sum : std::pow(sum, 1.0 / power);
  }
  double power_of(double offset) const {
    if (power == 2.0) return offset * offset;
    return power == 1.0 ? offset : std::pow(offset, power);
  }
};

/// The distances to the three nearest of random points, weighted. [S. Worley 1996, "A cellular texture basis function"]
class Crackle final : public Pattern {
 public:
  Crackle(const CrackleParameters& parameters, int noise_generator)
      : parameters_(parameters), metric_{parameters.metric}, generator_(noise_generator) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) {
      const Vec3 point = at.vector(i);
      values[i] = value(point, points_about(corner_below(point)));
    }
  }

 private:
  double value(const Vec3& point, const NearPoints& points) const {
    std::array<double, 3> least = {INFINITY, INFINITY, INFINITY};
    std::size_t nearest = 0;
    std::array<double, kNear> sums;
    metric_.sums(point, points, sums);
    for (std::size_t i = 0; i < kNear; ++i) {
      const double sum = sums[i];
      if (sum < least[0]) {
        least = {sum, least[0], least[1]};
        nearest = i;
      } else if (sum < least[1]) {
        least = {least[0], sum, least[1]};
      } else if (sum < least[2]) {
        least[2] = sum;
      }
    }
    if (parameters_.solid) return noise(points[nearest], generator_);
    const double more = parameters_.offset != 0.0 ? metric_.power_of(parameters_.offset) : 0.0;
    const auto distance = [&](std::size_t i) { return metric_.root(least[i] + more); };
    const Vec3& form = parameters_.form;
    return std::max(std::min(form.x * distance(0) + form.y * distance(1) + form.z * distance(2), 1.0), 0.0);
  }

  CrackleParameters parameters_;
  Metric metric_;
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
    constexpr double kSmallest = 1e-6;
    const double scale = parameters_.size < kSmallest ? 1.0 / kSmallest : 1.0 / parameters_.size;
    for (std::size_t i = 0; i < points.size; ++i) {
      const Vec3 normal = normals.vector(i).normalized();
      const Vec3 place = (parameters_.coords != 0.0 ? at.vector(i) : normal) * scale;
      const Vec3 facet = nearest(place, points_about(corner_below(place)));
      if (parameters_.coords == 0.0) {
        normals.set(i, facet);
      } else {
        const Vec3 shove = dnoise(facet);
        normals.set(i, normal + (shove - normal * shove.dot(normal)) * parameters_.coords);
      }
    }
  }

 private:
  /// With metric 1 the steps are not taken without their signs. [POV-Ray 3.7]
  double distance(const Vec3& v) const {
    return parameters_.metric == 1.0 ? v.x + v.y + v.z : Metric{parameters_.metric}.sum(v);
  }
  Vec3 nearest(const Vec3& place, const NearPoints& points) const {
    std::size_t best = 0;
    double least = distance(points[0] - place);
    for (std::size_t i = 1; i < kNear; ++i) {
      const double sum = distance(points[i] - place);
      if (sum < least) {
        least = sum;
        best = i;
      }
    }
    return points[best];
  }

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
