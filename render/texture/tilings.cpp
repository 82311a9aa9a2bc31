// The pattern `tiling`: 24 ways to cover the x-z plane with tiles that repeat, all with sides of 1 as far as they have one length,
// and three that never repeat (penrose.h). Source: POV-Ray 3.7's tilings of the same numbers; manual, "Tiling".

#include "render/lanes/math.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"
#include "render/texture/penrose.h"
#include "render/texture/polygon_tiling.h"

#include <cmath>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

using Tiles = std::vector<PolygonTile>;

constexpr double kRoot2 = 1.41421356237309504880;
constexpr double kRoot3 = 1.73205080756887729353;
constexpr double kHeight = kRoot3 / 2.0;   // of an equilateral triangle
constexpr double kThird = kRoot3 / 6.0;    // from its side to its middle
constexpr double kLozenge = kRoot3 / 4.0;  // half the width of a rhombus of two such triangles

Vec2 turned(const Vec2& point, const Vec2& about, double degrees) {
  const double angle = degrees * 0.017453292519943295769;
  const Vec2 from = point - about;
  return about + Vec2(from.x * steady::cosine(angle) - from.y * steady::sine(angle),
                      from.x * steady::sine(angle) + from.y * steady::cosine(angle));
}

PolygonTile turned(PolygonTile tile, const Vec2& about, double degrees) {
  for (Vec2& corner : tile.corners) corner = turned(corner, about, degrees);
  return tile;
}

PolygonTile polygon(std::size_t kind, double reach, std::vector<Vec2> corners) {
  return {kind, std::move(corners), reach, {}};
}

/// With a side that lies below its middle, along x. Its first edge is that one; the others follow counterclockwise.
PolygonTile regular(std::size_t kind, double reach, int sides, const Vec2& middle) {
  PolygonTile tile{kind, {}, reach, {}};
  const double half = 180.0 / sides;
  const Vec2 first(middle.x, middle.y - 0.5 / steady::sine(half * 0.017453292519943295769));
  for (int i = 0; i < sides; ++i) tile.corners.push_back(turned(first, middle, half * (2 * i - 1)));
  return tile;
}

PolygonTile rectangle(std::size_t kind, double left, double right, double low, double high) {
  return polygon(kind, 0.5, {{left, low}, {right, low}, {right, high}, {left, high}});
}

PolygonTile mirrored(PolygonTile tile, double x, double z) {
  for (Vec2& corner : tile.corners) corner = {corner.x * x, corner.y * z};
  return tile;
}

/// Triangles of the grid of triangles, those that stand (kind 0) on the x axis at `standing` and those that hang (kind
/// 1) down to it at `hanging`.
Tiles triangles(std::initializer_list<int> standing, std::initializer_list<int> hanging) {
  Tiles tiles;
  for (const int i : standing) tiles.push_back(polygon(0, kThird, {{i + 0.0, 0}, {i + 1.0, 0}, {i + 0.5, kHeight}}));
  for (const int i : hanging) {
    tiles.push_back(polygon(1, kThird, {{i + 0.0, 0}, {i + 0.5, kHeight}, {i - 0.5, kHeight}}));
  }
  return tiles;
}

/// A square with four rectangles around it, in [0, 3] x [0, 3].
Tiles pinwheel() {
  return {rectangle(2, 0, 1, 0, 2), rectangle(1, 1, 3, 0, 1), rectangle(2, 2, 3, 1, 3), rectangle(1, 0, 2, 2, 3),
          rectangle(0, 1, 2, 1, 2)};
}

PolygonTiling pinwheels() {
  Tiles tiles;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      for (const PolygonTile& tile : pinwheel()) tiles.push_back(mirrored(tile, x, z));
    }
  }
  for (PolygonTile& tile : tiles) {
    for (Vec2& corner : tile.corners) corner += Vec2(3.0);
  }
  return {{6, 0}, {0, 6}, 3, tiles};
}

PolygonTiling rhombi() {
  return {{1.5, kHeight},
          {0, kRoot3},
          3,
          {polygon(0, kLozenge, {{0, 0}, {1, 0}, {1.5, kHeight}, {0.5, kHeight}}),
           polygon(1, kLozenge, {{0, 0}, {0.5, kHeight}, {0, kRoot3}, {-0.5, kHeight}}),
           polygon(2, kLozenge, {{0, 0}, {-0.5, kHeight}, {-1.5, kHeight}, {-1, 0}})}};
}

PolygonTiling rectangles() {
  return {{4, 0},
          {0, 4},
          2,
          {rectangle(1, 0, 1, 0, 2), rectangle(0, 1, 3, 0, 1), rectangle(1, 3, 4, -1, 1), rectangle(1, 1, 2, 1, 3),
           rectangle(0, 2, 4, 1, 2), rectangle(0, 3, 5, 2, 3), rectangle(1, 2, 3, 2, 4), rectangle(0, 0, 2, 3, 4)}};
}

PolygonTiling pairs_of_rectangles() {
  return {{4, 0},
          {0, 4},
          2,
          {rectangle(1, 0, 1, 0, 2), rectangle(1, 1, 2, 0, 2), rectangle(0, 2, 4, 0, 1), rectangle(0, 2, 4, 1, 2),
           rectangle(0, 0, 2, 2, 3), rectangle(0, 0, 2, 3, 4), rectangle(1, 2, 3, 2, 4), rectangle(1, 3, 4, 2, 4)}};
}

PolygonTiling octagons() {
  constexpr double kMiddle = (1.0 + kRoot2) / 2.0;
  const Vec2 middle(kMiddle, kMiddle);
  return {{2 * kMiddle, 0},
          {0, 2 * kMiddle},
          2,
          {turned(regular(0, 0.5, 4, middle), middle, 45), regular(1, 0.5, 8, {0, 0})}};
}

PolygonTiling rows_of_squares_and_triangles() {
  Tiles tiles = triangles({0}, {0});
  for (PolygonTile& tile : tiles) {
    for (Vec2& corner : tile.corners) corner.y += 1.0;
  }
  tiles.push_back(polygon(2, kThird, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  return {{1, 0}, {0.5, 1.0 + kHeight}, 3, tiles};
}

PolygonTiling hexagons_and_triangles() {
  return {{2, 0},
          {1, kRoot3},
          3,
          {polygon(0, kThird, {{-1, 0}, {0, 0}, {-0.5, kHeight}}),
           polygon(1, kThird, {{-1, kRoot3}, {0, kRoot3}, {-0.5, kHeight}}), regular(2, kThird, 6, {0.5, kHeight})}};
}

/// Squares within a frame of four trapezia, whose kinds are right, left, upper and lower.
PolygonTiling framed_squares(std::size_t kinds, std::size_t square, std::initializer_list<std::size_t> frame) {
  constexpr double kScale = 1.0 / kRoot2;
  Tiles tiles;
  constexpr double kTurns[] = {0, 180, 90, 270};
  const PolygonTile right = polygon(0, 0.5, {{1, -1}, {2, -2}, {2, 2}, {1, 1}});
  std::size_t i = 0;
  for (const std::size_t kind : frame) {
    tiles.push_back(turned(right, {0, 0}, kTurns[i++]));
    tiles.back().kind = kind;
  }
  tiles.push_back(polygon(square, 0.5, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}));
  for (PolygonTile& tile : tiles) {
    tile.reach *= kScale;
    for (Vec2& corner : tile.corners) corner = (corner + Vec2(2.0)) * kScale;
  }
  return {{4 * kScale, 0}, {0, 4 * kScale}, kinds, tiles};
}

PolygonTiling squares_of_two_sizes() {
  return {{2, 1}, {-1, 2}, 2, {rectangle(0, 0, 1, 0, 1), rectangle(1, 1, 3, -1, 1)}};
}

/// A hexagon, three squares and two triangles. `squares`: below the hexagon, to its lower left and lower right;
/// `triangles`: left and right of the lower square.
PolygonTiling hexagons_squares_triangles(std::size_t kinds, std::initializer_list<std::size_t> squares,
                                         std::initializer_list<std::size_t> triangles) {
  const Vec2 middle(0.5 + kHeight, 0.5 + kHeight);
  const std::size_t* square = squares.begin();
  Tiles tiles{regular(kinds - 1, kThird, 6, middle)};
  const PolygonTile below =
      polygon(0, kThird, {{kHeight, -0.5}, {kHeight + 1, -0.5}, {kHeight + 1, 0.5}, {kHeight, 0.5}});
  for (const double degrees : {0.0, -60.0, 60.0}) {
    tiles.push_back(turned(below, middle, degrees));
    tiles.back().kind = *square++;
  }
  tiles.push_back(polygon(*triangles.begin(), kThird, {{0, 0}, {kHeight, -0.5}, {kHeight, 0.5}}));
  tiles.push_back(
      polygon(*(triangles.begin() + 1), kThird, {{2 * kHeight + 1, 0}, {kHeight + 1, -0.5}, {kHeight + 1, 0.5}}));
  return {{1.5 + kHeight, 0.5 + kHeight}, {0, 1.0 + kRoot3}, kinds, tiles};
}

PolygonTiling turned_squares_and_triangles() {
  constexpr double kHalf = 0.5 + kHeight;
  return {{kHalf, kHalf},
          {kHalf, -kHalf},
          6,
          {polygon(4, kThird, {{0, 0.5}, {kHeight, 0}, {kHalf, kHeight}, {0.5, kHalf}}),
           polygon(5, kThird, {{2 * kHalf, 0.5}, {2 * kHalf - kHeight, 0}, {kHalf, kHeight}, {2 * kHalf - 0.5, kHalf}}),
           polygon(0, kThird, {{0, -0.5}, {0, 0.5}, {kHeight, 0}}),
           polygon(1, kThird, {{-0.5, kHalf}, {0.5, kHalf}, {0, 0.5}}),
           polygon(2, kThird, {{kHalf, kHalf - 0.5}, {kHalf, kHalf + 0.5}, {0.5, kHalf}}),
           polygon(3, kThird, {{kHalf - 0.5, 0}, {kHalf + 0.5, 0}, {kHalf, kHeight}})}};
}

PolygonTiling snub_hexagons(bool right) {
  Tiles tiles = right ? triangles({0, 1, 2, 4}, {0, 1, 2, 5}) : triangles({0, 1, 4, 6}, {0, 1, 2, 4});
  tiles.push_back(regular(2, kThird, 6, {right ? 6.0 : 3.0, 0}));
  return {{7, 0}, {2.5, right ? -kHeight : kHeight}, 3, tiles};
}

PolygonTiling dodecagons_and_triangles() {
  constexpr double kMiddle = 1.0 + kHeight;
  PolygonTile dodecagon = regular(2, kThird, 12, {kMiddle, kMiddle});
  // The lower, right and left sides.
  for (const std::size_t edge : {0, 3, 9}) {
    dodecagon.edge_reach.resize(12);
    dodecagon.edge_reach[edge] = 1.0 / 3.0;
  }
  return {{2.0 + kRoot3, 0},
          {kMiddle, 1.5 + kRoot3},
          3,
          {dodecagon, polygon(0, kThird, {{-0.5, 0.5}, {0.5, 0.5}, {0, 0.5 + kHeight}}),
           polygon(1, kThird, {{-0.5, 1.5 + kRoot3}, {0.5, 1.5 + kRoot3}, {0, 1.5 + kHeight}})}};
}

/// A dodecagon, two hexagons (kind 0) and three squares: left of it, to its lower left and lower right.
PolygonTiling dodecagons_hexagons_squares(std::size_t kinds, std::initializer_list<std::size_t> squares) {
  const Vec2 middle(1.5 + kHeight, 1.0 + kRoot3);
  const PolygonTile hexagon = regular(0, 0.5, 6, {middle.x, 0});
  Tiles tiles{regular(kinds - 1, 0.5, 12, middle), hexagon, turned(hexagon, middle, 60)};
  double degrees = 0.0;
  for (const std::size_t kind : squares) {
    tiles.push_back(turned(regular(kind, 0.5, 4, {0, middle.y}), middle, degrees));
    degrees += 60.0;
  }
  return {{3.0 + kRoot3, 0}, {1.5 + kHeight, 1.5 + 1.5 * kRoot3}, kinds, tiles};
}

/// Pre: 1 to 24.
PolygonTiling repeating(int type) {
  switch (type) {
    case 2:
      return {{1.5, kHeight}, {0, kRoot3}, 1, {regular(0, kHeight, 6, {0.5, kHeight})}};
    case 3:
      return {{1, 0}, {0.5, kHeight}, 2, triangles({0}, {0})};
    case 4:
      return {{1, 0}, {0.5, kHeight}, 1, {polygon(0, kLozenge, {{0, 0}, {1, 0}, {1.5, kHeight}, {0.5, kHeight}})}};
    case 5:
      return rhombi();
    case 6:
      return rectangles();
    case 7:
      return octagons();
    case 8:
      return rows_of_squares_and_triangles();
    case 9:
      return hexagons_and_triangles();
    case 10:
      return {{1, 0}, {0.5, 1}, 1, {rectangle(0, 0, 1, 0, 1)}};
    case 11:
      return {{3, 0}, {0, 3}, 3, pinwheel()};
    case 12:
      return pinwheels();
    case 13:
      return framed_squares(3, 0, {2, 2, 1, 1});
    case 14:
      return framed_squares(5, 4, {0, 1, 3, 2});
    case 15:
      return squares_of_two_sizes();
    case 16:
      return hexagons_squares_triangles(3, {0, 0, 0}, {1, 1});
    case 17:
      return hexagons_squares_triangles(6, {0, 1, 2}, {4, 3});
    case 18:
      return pairs_of_rectangles();
    case 19:
      return snub_hexagons(true);
    case 20:
      return snub_hexagons(false);
    case 21:
      return turned_squares_and_triangles();
    case 22:
      return dodecagons_and_triangles();
    case 23:
      return dodecagons_hexagons_squares(3, {1, 1, 1});
    case 24:
      return dodecagons_hexagons_squares(5, {1, 2, 3});
    default:
      return {{1, 0}, {0, 1}, 1, {rectangle(0, 0, 1, 0, 1)}};
  }
}

}  // namespace

PatternPtr pattern::make_tiling(const PatternRequest& request) {
  const int type = request.get<TilingParameters>().type;
  if (type == 25) return make_field([](const Vec3& p) { return penrose_pentagons(p.x, p.z); });
  if (type == 26) return make_field([](const Vec3& p) { return penrose_kites(p.x, p.z); });
  if (type == 27) return make_field([](const Vec3& p) { return penrose_rhombi(p.x, p.z); });
  return make_field([tiling = std::make_shared<const PolygonTiling>(repeating(type))](const Vec3& p) {
    return tiling->at(p.x, p.z);
  });
}

}  // namespace firstlight::render
