// Patterns that divide space into cells of few kinds. Their values are places in a list.

#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {
namespace {

/// Points this little below a border belong to the cell above it, so that a surface which lies on a border (a floor at
/// y = 0, say) is all in one layer of cells whatever the rounding of its hit points. [POV-Ray 3.7]
constexpr double kBorder = 1e-10;

double checker(const Vec3& p) {
  const double cells = std::floor(p.x + kBorder) + std::floor(p.y + kBorder) + std::floor(p.z + kBorder);
  const double pairs = std::floor(0.5 * cells);
  return cells != 2.0 * pairs ? 1.0 : 0.0;
}

bool is_odd(double whole) { return whole - 2.0 * std::floor(0.5 * whole) != 0.0; }

double square(const Vec3& p) {
  const bool odd_x = is_odd(std::floor(p.x));
  const bool odd_z = is_odd(std::floor(p.z));
  return odd_x ? (odd_z ? 2.0 : 3.0) : (odd_z ? 1.0 : 0.0);
}

/// Six pyramids about the half axes: x, y, z, then those below zero.
double cubic(const Vec3& p) {
  const double x = std::abs(p.x), y = std::abs(p.y), z = std::abs(p.z);
  if (p.x >= 0 && p.x >= y && p.x >= z) return 0.0;
  if (p.y >= 0 && p.y >= x && p.y >= z) return 1.0;
  if (p.z >= 0 && p.z >= x && p.z >= y) return 2.0;
  if (p.x < 0 && x >= y && x >= z) return 3.0;
  if (p.y < 0 && y >= x && y >= z) return 4.0;
  return 5.0;
}

/// Equilateral triangles of side 1. A column of triangles, half as high as the period sqrt(3), holds a triangle that
/// stands on its side and the halves of two that hang beside it; further columns and the mirrored upper half take
/// other places of the list in turn.
double triangular(const Vec3& p) {
  constexpr double kHeight = 1.73205080756887729352;
  double x = p.x - 3.0 * std::floor(p.x / 3.0);
  double z = p.z - kHeight * std::floor(p.z / kHeight);
  const double column = std::floor(x);
  x -= column;
  const bool mirrored = z >= 0.5 * kHeight;
  if (mirrored) z = kHeight - z;
  double place = 1.0;
  if (x != 0.0 && x != 1.0) {
    const bool below_left = z / x < kHeight;
    const bool below_right = z / (1.0 - x) < kHeight;
    place = below_left && below_right ? 0.0 : below_right ? 1.0 : 3.0;
  }
  const bool odd = place != 0.0;
  place = std::fmod(odd ? place + 2.0 * column : 6.0 + place - 2.0 * column, 6.0);
  return mirrored ? 5.0 - place : place;
}

/// Hexagons of side 1 in three kinds, on a grid of blocks half a side wide and half a hexagon high, which repeats after
/// six. In columns 1 and 4 of it a slanting side cuts the blocks.
double hexagon(const Vec3& p) {
  constexpr double kBlockWidth = 0.5, kBlockHeight = 0.866025404, kPeriod = 5.196152424;
  double x = std::abs(p.x) / kBlockWidth;
  double z = (p.z < 0.0 ? kPeriod - std::abs(p.z) : p.z) / kBlockHeight;
  x -= std::floor(x / 6.0) * 6.0;
  z -= std::floor(z / 6.0) * 6.0;
  const int column = static_cast<int>(std::floor(x)) % 6;
  const int row = static_cast<int>(std::floor(z)) % 6;
  static constexpr std::array<std::uint8_t, 6> kOuter = {0, 1, 1, 2, 2, 0};
  static constexpr std::array<std::uint8_t, 6> kInner = {2, 2, 0, 0, 1, 1};
  static constexpr std::array<std::uint8_t, 6> kBelow = {0, 2, 1, 0, 2, 1};
  static constexpr std::array<std::uint8_t, 6> kAbove = {2, 1, 0, 2, 1, 0};
  const auto at = static_cast<std::size_t>(row);
  if (column == 0 || column == 5) return kOuter[at];
  if (column == 2 || column == 3) return kInner[at];
  double across = x - column;
  if ((column + row) % 2 == 1) across = 1.0 - across;
  if (across == 0.0) across = 0.0001;
  return ((z - row) / across < 1.0 ? kBelow : kAbove)[at];
}

/// Place within a period of 1, also below zero.
double part(double x) {
  const double rest = x - std::trunc(x);
  return rest < 0.0 ? rest + 1.0 : rest;
}

/// 0 in the mortar, 1 in the bricks; every other layer is shifted by half a brick.
double brick(const Vec3& p, const BrickParameters& bricks) {
  const double mortar = static_cast<float>(bricks.mortar - 2.0 * kBorder);
  const double shift = kBorder + mortar;
  const double x = (p.x + shift) / bricks.size.x;
  const double y = (p.y + shift) / bricks.size.y;
  const double z = (p.z + shift) / bricks.size.z;
  if (part(y) <= mortar / bricks.size.y) return 0.0;
  const bool odd = part(0.5 * y) <= 0.5;
  const double width = mortar / bricks.size.x;
  const double depth = mortar / bricks.size.z;
  const bool at_end = part(odd ? x : x + 0.5) <= width;
  const bool at_face = part(odd ? z + 0.5 : z) <= depth;
  return at_end || at_face ? 0.0 : 1.0;
}

}  // namespace

PatternPtr pattern::make_brick(const PatternRequest& request) {
  return make_field([parameters = request.get<BrickParameters>()](const Vec3& point) { return brick(point, parameters); });
}

PatternPtr pattern::make_checker(const PatternRequest&) { return make_field(checker); }
PatternPtr pattern::make_cubic(const PatternRequest&) { return make_field(cubic); }
PatternPtr pattern::make_hexagon(const PatternRequest&) { return make_field(hexagon); }
PatternPtr pattern::make_square(const PatternRequest&) { return make_field(square); }
PatternPtr pattern::make_triangular(const PatternRequest&) { return make_field(triangular); }

}  // namespace firstlight::render
