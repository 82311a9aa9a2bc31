#include "render/texture/pavement.h"

#include "render/math/vec.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace firstlight::render {
namespace {

constexpr double kRoot3 = 1.73205080756887729353;
constexpr double kHeight = kRoot3 / 2.0;  // of a triangle
constexpr double kMiddle = kRoot3 / 6.0;  // from a side of a triangle to its middle

int modulo(int a, int b) { return (a % b + b) % b; }
int floored(int a, int b) { return (a - modulo(a, b)) / b; }

const PavementWalls& walls_of(const PavementParameters& parameters) {
  const auto all = pavement_walls();
  const auto first = std::ranges::find_if(all, [&](const PavementWalls& walls) {
    return walls.sides == parameters.sides && walls.tiles == parameters.tiles;
  });
  return *(first + (parameters.pattern - 1));
}

/// The number of a row or column of cells, which may be any whole number, within a period of all pavements.
int number_of(double whole) {
  constexpr double kPeriod = 3600.0;
  return std::isfinite(whole) ? static_cast<int>(std::fmod(whole, kPeriod)) : 0;
}

int digit(char c) { return c <= '9' ? c - '0' : c - 'A' + 10; }

struct Place {
  int i, j;
};

/// Across a side of a triangle, which is the same side of the other.
Place across(Place triangle, int side) {
  const int back = modulo(triangle.i, 2) == 0 ? 1 : -1;
  if (side == 2) return {triangle.i + back, triangle.j - back};
  return {triangle.i + (side == 0 ? -back : back), triangle.j};
}

/// A corner of a standing triangle at the origin.
Vec2 corner_of_triangle(int corner) { return corner == 2 ? Vec2(0.5, kHeight) : Vec2(1.0 - corner, 0.0); }

}  // namespace

Pavement::Pavement(const PavementParameters& parameters)
    : grid_(&walls_of(parameters)),
      exterior_(parameters.exterior % 3),
      interior_(parameters.interior % 3),
      form_(parameters.form % (parameters.sides == 4 ? 4 : 3)) {
  for (const char c : grid_->walls) cells_.push_back({static_cast<std::uint8_t>(digit(c)), 0, {}});
  for (int j = 0; j < grid_->rows; ++j) {
    for (int i = 0; i < grid_->across; ++i) {
      grid_->sides == 4 ? look_around_square(i, j) : look_around_triangle(i, j);
    }
  }
}

std::size_t Pavement::index(int i, int j) const {
  const int times = floored(j, grid_->rows);
  const int column = modulo(i - grid_->skew * times, grid_->across);
  return static_cast<std::size_t>(column + (j - times * grid_->rows) * grid_->across);
}

void Pavement::look_around_square(int i, int j) {
  constexpr std::array<Place, 4> kBeside{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
  for (int side = 0; side < 4; ++side) {
    const int next = (side + 1) % 4;
    if (has_wall(i, j, side) || has_wall(i, j, next)) continue;
    const Place above = kBeside[static_cast<std::size_t>(side)];
    const Place beside = kBeside[static_cast<std::size_t>(next)];
    const bool ends = has_wall(i + above.i, j + above.j, next) || has_wall(i + beside.i, j + beside.j, side);
    if (ends) cell(i, j).concave |= static_cast<std::uint8_t>(1 << side);
  }
}

void Pavement::look_around_triangle(int i, int j) {
  for (int corner = 0; corner < 3; ++corner) {
    // Around the corner: across each side to a triangle that has the corner between that side and the third.
    int first = (corner + 1) % 3;
    int second = (corner + 2) % 3;
    if (has_wall(i, j, first) != has_wall(i, j, second)) {
      const int open = has_wall(i, j, first) ? second : first;
      const int wall = 3 - open - corner;
      const Place beyond = across({i, j}, open);
      if (has_wall(beyond.i, beyond.j, corner)) {
        cell(i, j).obtuse[static_cast<std::size_t>(corner)] |= static_cast<std::uint8_t>(1 << wall);
      }
    }
    if (has_wall(i, j, first) || has_wall(i, j, second)) continue;
    Place at{i, j};
    bool ends = false;
    for (int step = 0; step < 6; ++step) {
      at = across(at, second);
      const int third = 3 - first - second;
      first = second;
      second = third;
      ends = ends || has_wall(at.i, at.j, second);
    }
    if (ends) cell(i, j).concave |= static_cast<std::uint8_t>(1 << corner);
  }
}

double Pavement::in_square(double x, double z) const {
  const double column = std::floor(x);
  const double row = std::floor(z);
  const Cell& here = cell(number_of(column), number_of(row));
  x -= column;
  z -= row;
  const std::array<double, 4> depth{1.0 - z, 1.0 - x, z, x};  // from the sides
  const auto has = [&](std::size_t side) { return (here.walls >> side & 1) != 0; };
  const auto is_concave = [&](std::size_t corner) { return (here.concave >> corner & 1) != 0; };
  for (std::size_t corner = 0; corner < 4 && form_ < 3; ++corner) {
    // Opposite to the corner of a wall that ends here the tile's own border has one.
    if (!is_concave(corner) || !has((corner + 2) % 4) || !has((corner + 3) % 4)) continue;
    const double a = 2.0 * depth[corner];
    const double b = 2.0 * depth[(corner + 1) % 4];
    if (form_ == 2) return std::min(std::abs(std::sqrt(a * a + b * b) - 1.0), 1.0);
    if (form_ == 1) return std::min(std::abs(a + b - 1.0), 1.0);
    return std::max(std::max(a, b) - 1.0, 1.0 - std::max(a, b));
  }
  double value = 0.0;
  for (std::size_t side = 0; side < 4; ++side) {
    if (has(side)) value = std::max(value, 1.0 - 2.0 * depth[side]);
  }
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const double a = 2.0 * depth[corner];
    const double b = 2.0 * depth[(corner + 1) % 4];
    if (is_concave(corner)) {
      const double distance = interior_ == 2 ? std::sqrt(a * a + b * b) : interior_ == 1 ? a + b : std::max(a, b);
      value = std::max(value, 1.0 - distance);
    }
    if (!has(corner) || !has((corner + 1) % 4)) continue;
    if (exterior_ == 1) value = std::max(value, std::min(2.0 - (a + b), 1.0));
    if (exterior_ == 2 && a <= 1.0 && b <= 1.0) {
      value = std::max(value, std::min(std::sqrt((1.0 - a) * (1.0 - a) + (1.0 - b) * (1.0 - b)), 1.0));
    }
  }
  return value;
}

double Pavement::in_triangle(double x, double z) const {
  // The standing triangle whose parallelogram holds the place, or the hanging one beside it.
  const double row = std::floor(z / kHeight);
  z -= row * kHeight;
  const double shifted = x - 0.5 * row;
  const double column = std::floor(shifted - z / kRoot3);
  x = shifted - column;
  int i = 2 * number_of(column);
  const int j = number_of(row);
  if (kRoot3 * (1.0 - x) < z) {
    ++i;
    x = 1.5 - x;
    z = kHeight - z;
  }
  const Cell& here = cell(i, j);
  const Vec2 place(x, z);
  const std::array<double, 3> depth{0.5 * (kRoot3 * x - z), 0.5 * (kRoot3 * (1.0 - x) - z), z};  // from the sides
  const auto has = [&](int side) { return (here.walls >> side & 1) != 0; };
  const auto away = [&](int side) { return 1.0 - depth[static_cast<std::size_t>(side)] / kMiddle; };
  double value = 0.0;
  for (int side = 0; side < 3; ++side) {
    if (has(side)) value = std::max(value, away(side));
  }
  int nearest = 0;
  std::array<double, 3> distance;
  for (int corner = 0; corner < 3; ++corner) {
    distance[static_cast<std::size_t>(corner)] = (place - corner_of_triangle(corner)).length();
    if (distance[static_cast<std::size_t>(corner)] < distance[static_cast<std::size_t>(nearest)]) nearest = corner;
  }
  /// From a corner along a side of it.
  const auto along = [&](int corner, int side) {
    const Vec2 from = corner_of_triangle(corner);
    return (place - from).dot(corner_of_triangle(3 - corner - side) - from);
  };
  for (int corner = 0; corner < 3; ++corner) {
    if ((here.concave >> corner & 1) == 0) continue;
    if (interior_ == 0) {
      value = std::max(value, 1.0 - (kHeight - depth[static_cast<std::size_t>(corner)]) / kMiddle);
    } else if (interior_ == 2) {
      value = std::max(value, 1.0 - 3.0 * distance[static_cast<std::size_t>(corner)]);
    } else if (corner == nearest) {
      value = std::max(value, 1.0 - 3.0 * std::max(along(corner, (corner + 1) % 3), along(corner, (corner + 2) % 3)));
    }
  }
  for (int corner = 0; corner < 3; ++corner) {
    const int first = (corner + 1) % 3;
    const int second = (corner + 2) % 3;
    if (!has(first) || !has(second)) continue;
    if (exterior_ == 1 && away(first) >= 0.0 && away(second) >= 0.0) {
      value = std::min(std::abs(depth[static_cast<std::size_t>(corner)] - kMiddle) / kMiddle, 1.0);
    }
    if (exterior_ == 2 && corner == nearest) {
      value = std::min((place - Vec2(0.5, kMiddle)).length() / kMiddle, 1.0);
    }
  }
  for (int wall = 0; wall < 3 && form_ != 0; ++wall) {
    if ((here.obtuse[static_cast<std::size_t>(nearest)] >> wall & 1) == 0) continue;
    const int open = 3 - wall - nearest;
    if (form_ == 1) return std::min(2.0 - 4.0 * along(nearest, open), 1.0);
    return std::clamp((distance[static_cast<std::size_t>(wall)] - 2.0 * kMiddle) / kMiddle, 0.0, 1.0);
  }
  return value;
}

PatternPtr pattern::make_pavement(const PatternRequest& request) {
  return make_field([pavement = std::make_shared<const Pavement>(request.get<PavementParameters>())](const Vec3& p) {
    return pavement->at(p.x, p.z);
  });
}

}  // namespace firstlight::render
