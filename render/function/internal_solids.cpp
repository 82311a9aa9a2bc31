// Shapes made of distances, exponentials and angles.
// Source   The formulas as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"
#include "render/lanes/math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTurn = 2.0 * kPi;
/// In place of 0 where a point on the axis would have no angle.
constexpr double kBesideAxis = 0.000001;

double length_of(double a, double b) { return std::sqrt(a * a + b * b); }
double length_of(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }
double square(double a) { return a * a; }
double radians(double degrees) { return degrees * (kPi / 180.0); }

// A remainder that is never negative.
double wrap(double value, double period) {
  const double rest = std::fmod(value, period);
  return rest < 0.0 ? rest + period : rest;
}

// Parameters: distance of the parts, then of each its strength and inverse radius.
double blob(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double y2 = p[1] * p[1], z2 = p[2] * p[2], half = own[0] * 0.5;
  const auto part = [&](double x, double strength, double inverse) {
    const double rest = 1.0 - std::min((x * x + y2 + z2) * inverse * inverse, 1.0);
    return strength * rest * rest;
  };
  return -(part(p[0] + half, own[1], own[2]) + part(p[0] - half, own[3], own[4]));
}

// Parameters: distance, inverse size, strength, threshold.
double blob2(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double x2 = p[0] * p[0], y2 = p[1] * p[1], z2 = p[2] * p[2];
  const double sum =
      steady::exponential(-(x2 + y2 + z2) * own[1]) + steady::exponential(-(square(p[0] - own[0]) + y2 + z2) * own[1]);
  return own[3] - sum * own[2];
}

double comma(const double* p, const Evaluation&) {
  const double size = p[3];
  const double x = p[0] == 0 && p[2] == 0 ? 0.0001 : p[0], y = p[1], z = p[2];
  const double angle = steady::arc_tangent(z, x);
  const double around = length_of(x + size * 0.25, z);
  const double tail = steady::cosine(angle * 0.5) * size * 0.5 - length_of(around - size * 0.75, y);
  const double head = size * 0.5 - std::sqrt(square(x - size * 0.5) + z * z + y * y);
  return -std::max(std::min(z, tail), head);
}

/// Three ellipsoids, each long or short along an axis, as bells. Parameters: eccentricity, inverse size.
struct Ellipsoids {
  double along_z, along_y, along_x;
  explicit Ellipsoids(const double* p) {
    const double x2 = p[0] * p[0], y2 = p[1] * p[1], z2 = p[2] * p[2], e = p[3], inverse = p[4];
    along_z = steady::exponential(-(x2 * e + y2 * e + z2) * inverse);
    along_y = steady::exponential(-(x2 * e + y2 + z2 * e) * inverse);
    along_x = steady::exponential(-(x2 + y2 * e + z2 * e) * inverse);
  }
};

// Further parameters of these three: strength, threshold.
double cross_ellipsoids(const double* p, const Evaluation&) {
  const Ellipsoids e(p);
  return p[6] - std::max(std::max(e.along_z, e.along_y), e.along_x) * p[5];
}
double isect_ellipsoids(const double* p, const Evaluation&) {
  const Ellipsoids e(p);
  return p[6] - std::min(std::min(e.along_z, e.along_y), e.along_x) * p[5];
}
double flange_cover(const double* p, const Evaluation&) {
  const Ellipsoids e(p);
  return p[6] - (e.along_z + e.along_y + e.along_x) * p[5];
}

// Parameters: eccentricity, inverse size, strength; of the ball in the middle its inverse size and strength.
double spikes(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const Ellipsoids e(p);
  const double ball = steady::exponential(-(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * own[3]) * own[4];
  return -(ball - e.along_z - e.along_y - e.along_x) * own[2];
}

double spikes_2d(const double* p, const Evaluation&) {
  const double* own = p + 3;
  return -(own[0] * steady::cosine(own[1] * p[0]) * steady::cosine(own[2] * p[2]) *
               steady::exponential(-own[3] * (p[0] * p[0] + p[2] * p[2])) -
           p[1]);
}

double ellipsoid(const double* p, const Evaluation&) {
  const double* own = p + 3;
  return std::sqrt(p[0] * p[0] * own[0] * own[0] + p[1] * p[1] * own[1] * own[1] + p[2] * p[2] * own[2] * own[2]);
}

// Parameters: major radius, windings, twist, fatness, threshold, negative minor radius, further fatness, and period,
// amplitude and phase of the grooves.
double helical_torus(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double around = length_of(p[0], p[2]);
  const double x = p[0] == 0 && p[2] == 0 ? kBesideAxis : p[0];
  const double angle = steady::arc_tangent(x, p[2]);
  const double from_ring = length_of(around - own[0], p[1]);
  const double winding = wrap(angle * own[1] + steady::arc_tangent(around - own[0], p[1]) * own[2], kTurn) - kPi;
  const double groove_angle = steady::arc_tangent(winding * own[8], from_ring - own[5]);
  const double groove = steady::cosine(groove_angle * own[7] + angle * own[9]) * own[3] + own[4];
  const double tube =
      groove - std::min(std::sqrt(square(from_ring - own[5]) + winding * winding * own[6]), from_ring + own[5]);
  return -std::max(own[4] + own[5] - own[0] - around, tube);
}

// The distance from the middle of a tube's cross section: 1 a circle, 0 a square, between and beyond them rounded.
double cross_section(double x, double z, double kind) {
  if (kind == 1) return length_of(x, z);
  if (kind == 0) return std::max(std::abs(x), std::abs(z));
  const double power = 2.0 / kind;
  return steady::power(steady::power(std::abs(x), power) + steady::power(std::abs(z), power), kind * 0.5);
}

// Parameters: number of tubes, period, minor and major radius, shape, cross section and its angle.
double helix1(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double around = length_of(p[0], p[2]);
  const double x_or_beside = p[0] == 0 && p[2] == 0 ? kBesideAxis : p[0];
  const double angle = wrap(steady::arc_tangent(p[2], x_or_beside) * own[0] + p[1] * own[1] * own[0], kTurn);
  double z = (angle - kPi) / own[4] / (own[1] * own[0]);
  double x = around - own[3];
  if (own[5] != 1 && own[6] != 0) {
    const double cosine = steady::cosine(radians(own[6])), sine = steady::sine(radians(own[6]));
    const double turned = x * cosine - z * sine;
    z = x * sine + z * cosine;
    x = turned;
  }
  return -own[2] + std::min(own[3] + around, cross_section(x, z, own[5]));
}

double helix2(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double cosine = steady::cosine(p[1] * own[1]), sine = steady::sine(p[1] * own[1]);
  const double x = p[0] - own[3] * cosine, z = p[2] - own[3] * sine;
  return cross_section(x * cosine + z * sine, -x * sine + z * cosine, own[5]) - own[2];
}

/// A point of the plane in its cell of a pattern of hexagons.
struct Hexagon {
  double x, y;
  bool near_x;  ///< within 30 degrees of the x axis
  explicit Hexagon(const double* p) {
    const double width = std::sqrt(3.0);
    x = std::abs(std::fmod(std::abs(p[0]), width) - width / 2);
    y = std::abs(std::fmod(std::abs(p[1]), 3) - 1.5);
    const double other_x = width / 2 - x, other_y = 1.5 - y;
    if (x * x + y * y > other_x * other_x + other_y * other_y) {
      x = other_x;
      y = other_y;
    }
    near_x = steady::arc_tangent(y, x) < kPi / 6;
  }
};

double hex_x(const double* p, const Evaluation&) {
  const Hexagon h(p);
  return h.near_x ? h.x : steady::cosine(kPi / 3) * h.x + steady::sine(kPi / 3) * h.y;
}

double hex_y(const double* p, const Evaluation&) {
  const Hexagon h(p);
  return h.near_x ? h.y : std::abs(-steady::sine(kPi / 3) * h.x + steady::cosine(kPi / 3) * h.y);
}

// Woven threads. Parameters: distances along x and z, thickness, amplitude, thickness along y.
double mesh1(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double x = p[0], y = p[1], z = p[2];
  const auto thread = [&](double across, double distance, double wave) {
    const double aside = std::abs(wrap(across, distance * 2) - distance) * own[2];
    return -length_of((y + wave) * own[4], aside);
  };
  const double wave_z = steady::cosine(z * (kPi / own[1])) * own[3],
               wave_x = steady::cosine(x * (kPi / own[0])) * own[3];
  double nearest = thread(x, own[0], -wave_z);
  nearest = std::max(thread(x - own[0], own[0], wave_z), nearest);
  nearest = std::max(thread(z, own[1], wave_x), nearest);
  return -std::max(thread(z - own[1], own[1], -wave_x), nearest);
}

double ph(const double* p, const Evaluation&) { return steady::arc_tangent(length_of(p[0], p[2]), p[1]); }
double th(const double* p, const Evaluation&) { return steady::arc_tangent(p[0], p[2]); }
double r(const double* p, const Evaluation&) { return length_of(p[0], p[1], p[2]); }

// A radius that is a polynomial of y.
double poly4(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double y2 = p[1] * p[1];
  const double radius = own[0] + own[1] * p[1] + own[2] * y2 + own[3] * y2 * p[1] + own[4] * y2 * y2;
  return -(radius < -5.0 ? -5.0 : radius) + length_of(p[0], p[2]);
}

// Parameters: number of tubes about the y axis, and the polynomial of y that is their distance from it.
double polytubes(const double* p, const Evaluation&) {
  constexpr double kMostTubes = 100000.0;
  const double* own = p + 3;
  const double y2 = p[1] * p[1];
  const double away = own[1] + own[2] * p[1] + own[3] * y2 + own[4] * y2 * p[1] + own[5] * y2 * y2;
  double nearest = -10000;
  const int tubes = own[0] > 0.0 ? static_cast<int>(std::min(own[0], kMostTubes)) : 0;
  for (int i = 0; i < tubes; ++i) {
    const double x = p[0] - away * steady::sine(2 * kPi / own[0] * i),
                 z = p[2] - away * steady::cosine(2 * kPi / own[0] * i);
    nearest = std::max(nearest, -length_of(x, z));
  }
  return -nearest;
}

double quantum(const double* p, const Evaluation&) {
  const double x = p[0] == 0 && p[2] == 0 ? 1e-6 : p[0];
  const double around = length_of(x, p[2]);
  const double cosine = steady::cosine(steady::arc_tangent(around, p[1]));
  const double distance = length_of(around, p[1]) * 2.0;
  const double wave = distance * distance * steady::exponential(-distance * 0.33333333) * (3.0 * cosine * cosine - 1);
  return (wave * wave - 12.0) * (-0.1);
}

// Parameters: radius of the edges, half of the sides.
double rounded_box(const double* p, const Evaluation&) {
  double beyond[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double half = p[4 + axis] - p[3], x = p[axis];
    const double above = x < half ? 0 : x - half;
    beyond[axis] = std::max(x > -half ? 0 : -half - x, above);
  }
  return -p[3] + length_of(beyond[0], beyond[1], beyond[2]) - 1e-6;
}

double sphere(const double* p, const Evaluation&) { return -p[3] + length_of(p[0], p[1], p[2]); }

// Parameters: distance of the turns, thickness, outer diameter, two without effect, cross section.
double spiral(const double* p, const Evaluation&) {
  const double* own = p + 3;
  const double x = p[0] == 0 && p[2] == 0 ? kBesideAxis : p[0], y = p[1];
  const double along = length_of(p[0], p[2]) + own[0] * steady::arc_tangent(p[2], x) / kTurn;
  const double across = std::fmod(along, own[0]) - own[0] * 0.5;
  double tube = 0.0;
  if (own[5] == 1) {
    tube = length_of(across, y);
  } else if (own[5] != 0) {
    const double power = 2 / own[5];
    tube = steady::power(steady::power(std::abs(across), power) + steady::power(std::abs(y), power), 1.0 / power);
  } else {
    tube = std::max(std::abs(across), std::abs(y));
  }
  const double distance = length_of(x, y, p[2]);
  return -std::min(own[2] - distance, own[1] - std::min(tube, distance));
}

double superellipsoid(const double* p, const Evaluation&) {
  const double east = p[3], north = p[4], power = 2 / east, inverse = 1 / north;
  const double round =
      steady::power(steady::power(std::abs(p[0]), power) + steady::power(std::abs(p[1]), power), east * inverse);
  return 1 - steady::power(round + steady::power(std::abs(p[2]), 2 * inverse), north * 0.5);
}

double torus(const double* p, const Evaluation&) { return -p[4] + length_of(length_of(p[0], p[2]) - p[3], p[1]); }

constexpr InternalFunction kRows[] = {
    {6, blob, 8},
    {7, blob2, 7},
    {9, comma, 4},
    {10, cross_ellipsoids, 7},
    {17, ellipsoid, 6},
    {19, flange_cover, 7},
    {24, helical_torus, 13},
    {25, helix1, 10},
    {26, helix2, 10},
    {27, hex_x, 4},
    {28, hex_y, 4},
    {32, isect_ellipsoids, 7},
    {40, mesh1, 8},
    {47, ph, 3},
    {51, poly4, 8},
    {52, polytubes, 9},
    {53, quantum, 4},
    {57, r, 3},
    {60, rounded_box, 7},
    {61, sphere, 4},
    {62, spikes, 8},
    {63, spikes_2d, 7},
    {64, spiral, 9},
    {68, superellipsoid, 5},
    {69, th, 3},
    {70, torus, 5},
};

}  // namespace

std::span<const InternalFunction> internal_solids() { return kRows; }

}  // namespace firstlight::render
