#pragma once

#include "render/light/light.h"
#include "render/math/random.h"

#include <array>
#include <cstddef>
#include <vector>

namespace firstlight::render {

/// Where the points of an area light are, for one point that is lit: `orient` and `jitter` go by it.
/// Source   POV-Ray 3.7 manual, "Area Lights"; the formulas are POV-Ray 3.7's.
class AreaGrid {
 public:
  /// The purpose that points are asked for: each has a jitter of its own.
  enum class Use { shadow, illumination };

  /// Pre: light.area, which outlives it.
  AreaGrid(const Light& light, const Vec3& lit_point, Use use);

  /// The place of the point in column u and row v. Pre: u < size1, v < size2.
  Vec3 place(int u, int v) const;
  /// The place that lies so far along the axes, as AreaTable tells.
  Vec3 place(const Vec2& along) const { return light_.position + (axis1_ * along.x + axis2_ * along.y); }

 private:
  const Light& light_;
  const AreaLight& area_;
  Vec3 axis1_;
  Vec3 axis2_;
  HashedDraws draws_;
  Use use_;
};

/// How far along the axes the points of an area light are that has no jitter, whatever is lit.
class AreaTable {
 public:
  /// Pre: light.area.
  explicit AreaTable(const Light& light);

  /// Whether it has none: there are too many points, or each lit point has its own.
  bool empty() const { return along_.empty(); }
  /// Row after row of a column, column after column.
  const Vec2& operator[](std::size_t number) const { return along_[number]; }

 private:
  static constexpr std::size_t kMostPoints = std::size_t{1} << 14;
  std::vector<Vec2> along_;
};

/// A rectangle of grid points, its corners included, that is looked at by its corners alone or in quarters.
struct AreaRectangle {
  int u1 = 0;
  int v1 = 0;
  int u2 = 0;
  int v2 = 0;

  /// The corners in POV-Ray's order.
  std::array<std::array<int, 2>, 4> corners() const { return {{{u1, v1}, {u2, v1}, {u1, v2}, {u2, v2}}}; }
  bool has_quarters() const { return u2 - u1 > 1 || v2 - v1 > 1; }
};

/// The different ones among the quarters of a rectangle, and how many times each counts.
struct AreaQuarters {
  std::array<AreaRectangle, 4> of;
  std::size_t size = 0;
  int times = 1;
};
/// The quarters of a rectangle; the middle ones of an odd number of points are in both halves. Pre:
/// rectangle.has_quarters().
AreaQuarters quarters_of(const AreaRectangle& rectangle);

/// Whether light as it comes from the corners of a rectangle, in their order, differs so much that its quarters have to
/// be looked at.
bool differ(const std::array<Rgb, 4>& corners);

}  // namespace firstlight::render
