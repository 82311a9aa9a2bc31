#include "render/shape/height_field.h"

#include "render/math/transform.h"
#include "render/shape/box.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kFull = 65536.0;
constexpr double kRoom = 0.001;          ///< POV-Ray's box is so much higher than the land, in its own space
constexpr double kNearest = 1e-6;        ///< POV-Ray's for this shape
constexpr double kTriangleRoom = 1e-4;   ///< so far beyond its sides a triangle is met
constexpr int kBlock = 16;               ///< cells along a side of those that are passed over together

/// Visits the squares of a grid that a ray passes between two depths, in order.
/// visit(x, z, enters, leaves) returns false to end. `size`: of a square.
template <class Visit>
void walk_grid(const Ray& ray, double enters, double leaves, double size, int columns, int rows, const Visit& visit) {
  struct Axis {
    double origin;
    double direction;
    int count;
    int at;

    /// Depth of the border that is passed next.
    double next(double of_size) const {
      if (direction == 0.0) return kBoundless;
      return ((at + (direction > 0.0 ? 1 : 0)) * of_size - origin) / direction;
    }
  };
  const Vec3 start = ray.at(enters);
  const auto square_of = [size](double place, int count) {
    return std::clamp(static_cast<int>(std::floor(place / size)), 0, count - 1);
  };
  Axis x{ray.origin.x, ray.direction.x, columns, square_of(start.x, columns)};
  Axis z{ray.origin.z, ray.direction.z, rows, square_of(start.z, rows)};
  double from = enters;
  for (;;) {
    const double next_x = x.next(size);
    const double next_z = z.next(size);
    const double to = std::min({next_x, next_z, leaves});
    if (!visit(x.at, z.at, from, to)) return;
    if (to >= leaves) return;
    Axis& crossed = next_x <= next_z ? x : z;
    crossed.at += crossed.direction > 0.0 ? 1 : -1;
    if (crossed.at < 0 || crossed.at >= crossed.count) return;
    from = to;
  }
}

/// The land in a space where points of the grid are 1 apart and heights are as they are given.
class Land {
 public:
  explicit Land(HeightFieldParameters parameters) : given_(std::move(parameters)) {
    const auto [low, high] = std::ranges::minmax(given_.heights);
    low_ = std::max(static_cast<double>(low), given_.water_level * kFull) - kRoom;
    high_ = static_cast<double>(high) + kRoom;
    make_blocks();
    if (given_.smooth) make_normals();
  }

  bool is_smooth() const { return given_.smooth; }
  Box3 box() const { return Box3(Vec3(0.0, low_, 0.0), Vec3(given_.columns - 1.0, high_, given_.rows - 1.0)); }
  Transform to_unit() const {
    return Transform::scaling(Vec3(1.0 / (given_.columns - 1.0), 1.0 / kFull, 1.0 / (given_.rows - 1.0)));
  }

  /// Calls add(depth, face), which returns whether to go on, in about the order of depths.
  template <class Add>
  void meet(const Ray& ray, const Add& add) const {
    BoxMet met;
    const Box3 around = box();
    AxisBox{around.min, around.max}.meet(ray, met);
    if (met.count == 0) return;
    const double leaves = met.depth[met.count - 1];
    const double enters = std::max(met.count == 2 ? met.depth[0] : kNearest, kNearest);
    if (enters > leaves) return;
    const int columns = given_.columns - 1;
    const int rows = given_.rows - 1;
    bool goes_on = true;
    walk_grid(ray, enters, leaves, kBlock, block_columns_, block_rows_, [&](int bx, int bz, double from, double to) {
      const Block& block = blocks_[static_cast<std::size_t>(bz) * static_cast<std::size_t>(block_columns_) +
                                   static_cast<std::size_t>(bx)];
      if (!passes(ray, from, to, block.low, block.high)) return true;
      walk_grid(ray, from, to, 1.0, columns, rows, [&](int x, int z, double near, double far) {
        goes_on = meet_cell(ray, x, z, near, far, enters, leaves, add);
        return goes_on;
      });
      return goes_on;
    });
  }

  bool holds(const Vec3& p) const {
    if (p.x < 0.0 || p.x >= given_.columns - 1.0 || p.z < 0.0 || p.z >= given_.rows - 1.0 || p.y >= high_) return false;
    if (p.y < low_) return true;
    int x = static_cast<int>(p.x);
    int z = static_cast<int>(p.z);
    const auto land = [&](int at_x, int at_z) { return std::max(height(at_x, at_z), low_); };
    Vec3 normal;
    if ((p.x - x) + (p.z - z) < 1.0) {
      normal = Vec3(land(x, z) - land(x + 1, z), 1.0, land(x, z) - land(x, z + 1));
    } else {
      x = static_cast<int>(std::ceil(p.x));
      z = static_cast<int>(std::ceil(p.z));
      normal = Vec3(land(x - 1, z) - land(x, z), 1.0, land(x, z - 1) - land(x, z));
    }
    return p.dot(normal) < Vec3(x, land(x, z), z).dot(normal);
  }

  /// The normal of the triangle that was met.
  Vec3 flat_normal(std::uint32_t face) const {
    const auto cell = static_cast<int>(face / 2);
    const int x = cell % (given_.columns - 1);
    const int z = cell / (given_.columns - 1);
    return triangle_normal(x, z, face % 2 != 0);
  }
  /// Calls take(normal, weight) for the corners of the cell around a point.
  template <class Take>
  void smooth_normals(const Vec3& p, const Take& take) const {
    const int x = std::clamp(static_cast<int>(p.x), 0, given_.columns - 2);
    const int z = std::clamp(static_cast<int>(p.z), 0, given_.rows - 2);
    const double u = p.x - x;
    const double v = p.z - z;
    take(Vec3(normals_[index(x, z)]), (1.0 - v) * (1.0 - u));
    take(Vec3(normals_[index(x + 1, z)]), (1.0 - v) * u);
    take(Vec3(normals_[index(x, z + 1)]), v * (1.0 - u));
    take(Vec3(normals_[index(x + 1, z + 1)]), v * u);
  }

 private:
  struct Block {
    double low;
    double high;
  };
  using Short3 = Imath::Vec3<short>;

  std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(given_.columns) + static_cast<std::size_t>(x);
  }
  double height(int x, int z) const { return given_.heights[index(x, z)]; }
  static bool passes(const Ray& ray, double from, double to, double low, double high) {
    const double a = ray.origin.y + from * ray.direction.y;
    const double b = ray.origin.y + to * ray.direction.y;
    return std::max(a, b) >= low - kRoom && std::min(a, b) <= high + kRoom;
  }
  Vec3 triangle_normal(int x, int z, bool far) const {
    if (far) return Vec3(height(x, z + 1) - height(x + 1, z + 1), 1.0, height(x + 1, z) - height(x + 1, z + 1));
    return Vec3(height(x, z) - height(x + 1, z), 1.0, height(x, z) - height(x, z + 1));
  }

  template <class Add>
  bool meet_cell(const Ray& ray, int x, int z, double near, double far, double enters, double leaves,
                 const Add& add) const {
    const std::array<double, 4> y = {height(x, z), height(x + 1, z), height(x, z + 1), height(x + 1, z + 1)};
    const auto [low, high] = std::ranges::minmax(y);
    // A little more than the ray has of the cell, for a triangle is met a little beyond its sides.
    const double more = kTriangleRoom * (far - near) + kNearest;
    if (!passes(ray, near - more, far + more, low, high)) return true;
    bool goes_on = true;
    for (const bool is_far : {false, true}) {
      const Vec3 normal = triangle_normal(x, z, is_far);
      const double approach = normal.dot(ray.direction);
      if (std::abs(approach) <= kEpsilon) continue;
      const Vec3 corner = is_far ? Vec3(x + 1.0, y[3], z + 1.0) : Vec3(x, y[0], z);
      const double depth = normal.dot(corner - ray.origin) / approach;
      if (!(depth >= enters && depth <= leaves)) continue;
      const double s = ray.origin.x + depth * ray.direction.x - x;
      const double t = ray.origin.z + depth * ray.direction.z - z;
      const bool is_in = is_far ? s <= 1.0 + kTriangleRoom && t <= 1.0 + kTriangleRoom && s + t >= 1.0 - kTriangleRoom
                                : s >= -kTriangleRoom && t >= -kTriangleRoom && s + t <= 1.0 + kTriangleRoom;
      if (!is_in) continue;
      const auto cell = static_cast<std::uint32_t>(z * (given_.columns - 1) + x);
      goes_on = add(depth, 2 * cell + (is_far ? 1 : 0)) && goes_on;
    }
    return goes_on;
  }

  void make_blocks() {
    block_columns_ = (given_.columns - 2) / kBlock + 1;
    block_rows_ = (given_.rows - 2) / kBlock + 1;
    for (int bz = 0; bz < block_rows_; ++bz) {
      for (int bx = 0; bx < block_columns_; ++bx) {
        Block block{kFull, 0.0};
        for (int z = bz * kBlock; z <= std::min((bz + 1) * kBlock, given_.rows - 1); ++z) {
          for (int x = bx * kBlock; x <= std::min((bx + 1) * kBlock, given_.columns - 1); ++x) {
            block.low = std::min(block.low, height(x, z));
            block.high = std::max(block.high, height(x, z));
          }
        }
        blocks_.push_back(block);
      }
    }
  }

  /// The mean of those of the triangles around, kept in 16 bits. [POV-Ray 3.7]
  void make_normals() {
    normals_.reserve(given_.heights.size());
    for (int z = 0; z < given_.rows; ++z) {
      for (int x = 0; x < given_.columns; ++x) {
        Vec3 sum(0.0);
        const auto is_there = [&](int at_x, int at_z) {
          return at_x >= 0 && at_z >= 0 && at_x < given_.columns && at_z < given_.rows;
        };
        const auto add = [&](int x1, int z1, int x2, int z2) {
          if (!is_there(x1, z1) || !is_there(x2, z2)) return;
          const Vec3 here(x, height(x, z), z);
          Vec3 n = (Vec3(x2, height(x2, z2), z2) - here).cross(Vec3(x1, height(x1, z1), z1) - here);
          n = n.length() > kEpsilon ? n / n.length() : Vec3(0.0, 1.0, 0.0);
          sum += n.y < 0.0 ? -n : n;
        };
        add(x + 1, z, x, z + 1);
        add(x, z + 1, x - 1, z);
        add(x - 1, z, x, z - 1);
        add(x, z - 1, x + 1, z);
        sum = sum.length() > kEpsilon ? sum / sum.length() : Vec3(0.0, 1.0, 0.0);
        normals_.emplace_back(static_cast<short>(32767 * sum.x), static_cast<short>(32767 * sum.y),
                              static_cast<short>(32767 * sum.z));
      }
    }
  }

  HeightFieldParameters given_;
  double low_;
  double high_;
  std::vector<Block> blocks_;
  int block_columns_ = 0;
  int block_rows_ = 0;
  std::vector<Short3> normals_;
};

/// A landscape where it stands.
class HeightField final : public Shape {
 public:
  HeightField(std::shared_ptr<const Land> land, Transform transform, bool inverted)
      : land_(std::move(land)), transform_(std::move(transform)), inverted_(inverted) {}

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    meet(ray, out, [](double) { return true; });
  }
  void nearest(const Ray& ray, double low, double, std::vector<Crossing>& out) const override {
    meet(ray, out, [low](double depth) { return !(depth > low); });
  }
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
  template <class GoesOn>
  void meet(const Ray& ray, std::vector<Crossing>& out, const GoesOn& goes_on) const {
    land_->meet(transform_.inverse_ray(ray), [&](double depth, std::uint32_t face) {
      out.push_back({depth, this, 0, face, {}});
      return goes_on(depth);
    });
  }

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
