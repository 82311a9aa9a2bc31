#include "render/texture/warp.h"

#include "render/math/lattice_random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// Patterns are evaluated no farther from their origin than this. [POV-Ray 3.7]
constexpr double kFarthest = 1e17;

Vec3 moved(const Turbulence& turbulence, const Vec3& point) {
  return point + dturbulence(point, octaves_of(turbulence)) * turbulence.amount;
}

// The point before a warp for one behind it. [POV-Ray 3.7]
Vec3 unwarped(const Transform& transform, const Vec3& point) { return transform.inverse_point(point); }
Vec3 unwarped(const Turbulence& turbulence, const Vec3& point) { return moved(turbulence, point); }
/// Every other block is mirrored along the axes that flip; blocks are counted in single precision.
Vec3 unwarped(const RepeatWarp& repeat, const Vec3& point) {
  const int axis = repeat.axis;
  const auto width = static_cast<float>(repeat.width);
  const auto block = static_cast<float>(std::floor(point[axis] / static_cast<double>(width)));
  Vec3 there = point;
  there[axis] = point[axis] - static_cast<double>(block * width);
  if (std::fmod(block, 2.0f) != 0.0f) {
    there *= repeat.flip;
    if (repeat.flip[axis] < 0.0) there[axis] = static_cast<double>(width) + there[axis];
  }
  return there + repeat.offset * static_cast<double>(block);
}

/// Points are moved from the hole's centre, the further the nearer they are, so that the pattern seems drawn in.
Vec3 unwarped(const BlackHoleWarp& hole, const Vec3& point) {
  constexpr double kNoBlock = 1e-10;
  Vec3 center = hole.center;
  if (hole.repeat) {
    Vec3 block(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      const double size = (*hole.repeat)[axis];
      if (size >= kNoBlock) block[axis] = std::floor(point[axis] / size);
    }
    if (hole.turbulence) {
      const unsigned hash = cell_hash(block.x, block.y, block.z);
      center += Vec3(table_random(hash), table_random(hash + 1), table_random(hash + 2)) * *hole.turbulence;
    }
    center += *hole.repeat * block;
  }
  const Vec3 way = point - center;
  const double distance = way.length();
  if (distance >= hole.radius || hole.type != 0) return point;
  const double nearness = (hole.radius - distance) / hole.radius;
  const double strength = std::min(std::pow(nearness, hole.falloff) * hole.strength, 1.0);
  return point + way * (hole.inverted ? -strength : strength);
}

/// A flat picture stands across z. Turns it across `direction`, the way POV-Ray does for the axes; other directions make
/// mixtures.
Vec3 turned(const Vec3& p, const Vec3& direction) {
  if (direction == Vec3(0.0, 0.0, 1.0)) return p;
  return {direction.x * p.z + direction.y * p.x + direction.z * p.x,
          direction.x * p.y + direction.y * -p.z + direction.z * p.y,
          direction.x * -p.x + direction.y * p.y + direction.z * p.z};
}

/// Part of a turn from the x axis towards z.
double turn_about_y(double x, double z, double length) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (z == 0.0) return x > 0.0 ? 0.0 : 0.5;
  const double angle = std::acos(x / length);
  return (z < 0.0 ? kTurn - angle : angle) / kTurn;
}

/// What angles are stretched by with distance.
double stretch(double distance, double exponent) {
  if (exponent == 0.0) return 1.0;
  return exponent == 1.0 ? distance : std::pow(distance, exponent);
}

Vec3 unwarped(const CylindricalWarp& warp, const Vec3& p) {
  const double distance = std::sqrt(p.x * p.x + p.z * p.z);
  if (distance == 0.0) return p;
  const double turn = turn_about_y(p.x, p.z, distance) * stretch(distance, warp.distance_exponent);
  return turned({turn, p.y, distance}, warp.orientation);
}

Vec3 unwarped(const SphericalWarp& warp, const Vec3& p) {
  const double distance = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
  if (distance == 0.0) return p;
  const Vec3 unit(p.x / distance, p.y / distance, p.z / distance);
  const double from_axis = std::sqrt(unit.x * unit.x + unit.z * unit.z);
  const double turn = from_axis == 0.0 ? 0.0 : turn_about_y(unit.x, unit.z, from_axis);
  const double up = 0.5 + std::asin(unit.y) / std::numbers::pi;
  const double factor = stretch(distance, warp.distance_exponent);
  return turned({turn * factor, up * factor, distance}, warp.orientation);
}

Vec3 unwarped(const ToroidalWarp& warp, const Vec3& p) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double from_axis = std::sqrt(p.x * p.x + p.z * p.z);
  if (from_axis == 0.0) return p;
  const double x = from_axis - warp.major_radius;
  const double distance = std::sqrt(x * x + p.y * p.y);
  double around = std::acos(-x / distance);
  if (p.y > 0.0) around = kTurn - around;
  const double factor = stretch(distance, warp.distance_exponent);
  return turned({turn_about_y(p.x, p.z, from_axis) * factor, around / kTurn * factor, distance}, warp.orientation);
}

Vec3 unwarped(const PlanarWarp& warp, const Vec3& p) { return turned({p.x, p.y, warp.offset}, warp.orientation); }

/// The six sides of a cube as they lie in a picture of its net, four wide and three high; z is the distance.
Vec3 unwarped(const CubicWarp&, const Vec3& p) {
  const double x = std::abs(p.x), y = std::abs(p.y), z = std::abs(p.z);
  const auto across = [](double place) { return 0.25 * (place + 1.0) / 2.0; };
  const auto up = [](double place) { return 1.0 / 3.0 * (place + 1.0) / 2.0; };
  constexpr double kMiddle = 1.0 / 3.0;
  if (p.x >= 0.0 && p.x >= y && p.x >= z) return {0.75 - across(p.z / p.x), kMiddle + up(p.y / p.x), p.x};
  if (p.y >= 0.0 && p.y >= x && p.y >= z) return {0.25 + across(p.x / p.y), 1.0 - up(p.z / p.y), p.y};
  if (p.z >= 0.0 && p.z >= x && p.z >= y) return {0.25 + across(p.x / p.z), kMiddle + up(p.y / p.z), p.z};
  if (p.x < 0.0 && x >= y && x >= z) return {across(p.z / x), kMiddle + up(p.y / x), x};
  if (p.y < 0.0 && y >= x && y >= z) return {0.25 + across(p.x / y), up(p.z / y), y};
  return {1.0 - across(p.x / -p.z), kMiddle + up(p.y / -p.z), -p.z};
}

}  // namespace

Octaves octaves_of(const Turbulence& turbulence) {
  return {turbulence.octaves, static_cast<float>(turbulence.lambda), static_cast<float>(turbulence.omega)};
}

void Warps::transform(const Transform& next) {
  if (next.is_identity()) return;
  if (!steps.empty()) {
    if (auto* last = std::get_if<Transform>(&steps.back())) {
      *last = last->then(next);
      return;
    }
  }
  steps.emplace_back(next);
}

Vec3 Warps::to_pattern(const Vec3& point, bool moves) const {
  Vec3 there = point;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    there = std::visit([&](const auto& warp) { return unwarped(warp, there); }, *step);
  }
  if (turbulence && moves) there = moved(*turbulence, there);
  const auto within = [](double x) { return std::clamp(x, -kFarthest, kFarthest); };
  return {within(there.x), within(there.y), within(there.z)};
}

Vec3 Warps::normal_to_pattern(const Vec3& normal) const {
  Vec3 there = normal;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (const auto* transform = std::get_if<Transform>(&*step)) there = transform->inverse().normal(there);
  }
  return there;
}

Vec3 Warps::normal_from_pattern(const Vec3& normal) const {
  Vec3 here = normal;
  for (const Warp& step : steps) {
    if (const auto* transform = std::get_if<Transform>(&step)) here = transform->normal(here);
  }
  return here;
}

}  // namespace firstlight::render
