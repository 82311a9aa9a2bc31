// Algebraic surfaces: the zeros of a polynomial of x, y and z, times a strength (the first parameter) and held within
// -10 and 10, so that a search for the surface is not led astray by its steep far parts.
// Source   The polynomials as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// Names for the arguments, and their squares.
struct Point {
  double x, y, z, x2, y2, z2;
  const double* own;  ///< the function's own parameters

  explicit Point(const double* p) : x(p[0]), y(p[1]), z(p[2]), x2(x * x), y2(y * y), z2(z * z), own(p + 3) {}
  double held(double value) const { return std::min(10.0, std::max(own[0] * value, -10.0)); }
};

double bicorn(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double size = p.own[1] * p.own[1];
  const double inner = p.x2 + p.z2 + 2 * p.own[1] * p.y - size;
  return p.held(p.y2 * (size - (p.x2 + p.z2)) - inner * inner);
}

double bifolia(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double sum = p.x2 + p.y * p.y + p.z2;
  return p.held(-(sum * sum - p.own[1] * (p.x2 + p.z2) * p.y));
}

double boy_surface(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double a = 1 - p.z, b = p.x2 + p.y2;
  const double first = 64 * a * a * a * p.z2 * p.z - 48 * a * a * p.z2 * (3 * p.x2 + 3 * p.y2 + 2 * p.z2);
  const double second =
      12 * a * p.z *
      (27 * b * b - 24 * p.z2 * b + 36 * std::numbers::sqrt2 * p.y * p.z * (p.y2 - 3 * p.x2) + 4 * p.z2 * p.z2);
  const double third =
      (9 * p.x2 + 9 * p.y2 - 2 * p.z2) *
      (-81 * b * b - 72 * p.z2 * b + 108 * std::numbers::sqrt2 * p.x * p.z * (p.x2 - 3 * p.y2) + 4 * p.z2 * p.z2);
  return p.held(p.own[1] * (first + second + third));
}

double crossed_trough(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(p.x2 * p.z * p.z - p.y);
}

double cubic_saddle(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x - p.y2 * p.y - p.z));
}

// Also `odd`, whose terms are the same in another order of factors.
double cushion(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double edge = p.x2 - p.z;
  return p.held(p.z2 * p.x2 - p.z2 * p.z2 - 2 * p.z * p.x2 + 2 * p.z2 * p.z + p.x2 - p.z2 - edge * edge - p.y2 * p.y2 -
                2 * p.x2 * p.y2 - p.y2 * p.z2 + 2 * p.y2 * p.z + p.y2);
}

double devils_curve(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x2 + 2 * p.x2 * p.z2 - 0.36 * p.x2 - p.y2 * p.y2 + 0.25 * p.y2 + p.z2 * p.z2));
}

// Parameters: strength, the torus' radii, its displacement along x and y, radius of inversion.
double dupin_cyclid(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double major = p.own[1], dx = p.own[3], dy = p.own[4];
  const double inversion = p.own[5] * p.own[5], minor2 = p.own[2] * p.own[2], dy2 = dy * dy;
  const double a = minor2 - dy2 - (dx + major) * (dx + major), b = minor2 - dy2 - (dx - major) * (dx - major);
  const double dx2 = dx * dx, major2 = major * major;
  return p.held(
      -(a * b * (p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2) + 2 * (a * b * (p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2)) +
        2 * inversion *
            ((-dy2 - dx2 + minor2 + major2) * (2 * p.x * dx + 2 * p.y * dy - inversion) - 4 * dy * minor2 * p.y) *
            (p.x2 + p.y2 + p.z2) +
        4 * inversion * inversion * (dx * p.x + dy * p.y) * (-inversion + dy * p.y + dx * p.x) +
        4 * inversion * inversion * major2 * p.y2 + inversion * inversion * inversion * inversion));
}

// POV-Ray divides whole numbers in some coefficients, so that 2/3, 1/4 and 2/9 are 0 there.
double enneper(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double z = std::abs(p.z) < 0.2 ? 0.2 : p.z;
  const double a = (p.y2 - p.x2) / (2 * z) + 2 * p.z2 / 9;
  const double b = (p.y2 - p.x2) / (4 * z);
  return p.held(-(a * a * a - 6 * b * b));
}

double folium_surface(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held((p.y2 + p.z2) * (1 + (p.own[2] - 4 * p.own[1]) * p.x) + p.x2 * (1 + p.own[2]));
}

double glob(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(0.5 * p.x2 * p.x2 * p.x + 0.5 * p.x2 * p.x2 - (p.y2 + p.z2));
}

double heart(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double ball = 2 * p.x2 + p.y2 + p.z2 - 1;
  return p.held(-(ball * ball * ball - 0.1 * p.x2 * p.z2 * p.z - p.y2 * p.z2 * p.z));
}

double hunt_surface(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double ball = p.x2 + p.y2 + p.z2 - 13, cone = 3 * p.x2 + p.y2 - 4 * p.z2 - 12;
  return p.held(-(4 * ball * ball * ball + 27 * cone * cone));
}

double hyperbolic_torus(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double major2 = p.own[1] * p.own[1], minor2 = p.own[2] * p.own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return p.held(-(p.x2 * p.x2 + 2 * p.x2 * p.y2 - 2 * p.x2 * p.z2 - 2 * sum * p.x2 + p.y2 * p.y2 - 2 * p.y2 * p.z2 +
                  2 * difference * p.y2 + p.z2 * p.z2 + 2 * sum * p.z2 + difference * difference));
}

double kampyle_of_eudoxus(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double closeness = p.own[2] * p.own[2];
  return p.held(-((p.y2 + p.z2) - closeness * p.x2 * p.x2 + closeness * p.own[1] * p.own[1] * p.x2));
}

double klein_bottle(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double inner = p.x2 + p.y2 + p.z2 - 2 * p.y - 1;
  return p.held(-((p.x2 + p.y2 + p.z2 + 2 * p.y - 1) * (inner * inner - 8 * p.z2) + 16 * p.x * p.z * inner));
}

double kummer_surface_v1(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(
      -(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 - p.x2 - p.y2 - p.z2 - p.x2 * p.y2 - p.x2 * p.z2 - p.y2 * p.z2 + 1));
}

double kummer_surface_v2(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 + p.own[1] * (p.x2 + p.y2 + p.z2) +
                  p.own[2] * (p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2) + p.own[3] * p.x * p.y * p.z - 1));
}

double lemniscate_of_gerono(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x2 - p.x2 + p.y2 + p.z2));
}

double mitre(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(4 * p.x2 * (p.x2 + p.y2 + p.z2) - p.y2 * (1 - p.y2 - p.z2)));
}

double nodal_cubic(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.y2 * p.y + p.z2 * p.z - 6 * p.y * p.z));
}

double ovals_of_cassini(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double sum = p.x2 + p.y2 + p.z2 + p.own[1] * p.own[1];
  return p.held(-(sum * sum - p.own[3] * p.own[1] * p.own[1] * (p.x2 + p.z2) - p.own[2] * p.own[2]));
}

double paraboloid(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 - p.y + p.z2));
}

double parabolic_torus(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double major2 = p.own[1] * p.own[1], minor2 = p.own[2] * p.own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return p.held(-(p.x2 * p.x2 + 2 * p.x2 * p.y2 - 2 * p.x2 * p.z - sum * p.x2 + p.y2 * p.y2 - 2 * p.y2 * p.z +
                  difference * p.y2 + p.z2 + sum * p.z + difference * difference));
}

double pillow(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 - (p.x2 + p.y2 + p.z2));
}

double piriform(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return -p.held(-((p.x2 * p.x2 - p.x2 * p.x) + p.y2 + p.z2));
}

double quartic_paraboloid(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x2 + p.z2 * p.z2 - p.y));
}

double quartic_saddle(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.x2 - p.z2 * p.z2 - p.y));
}

double quartic_cylinder(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double ring = p.x2 + p.z2, width = p.own[2] * p.own[2];
  return p.held(-(ring * p.y * p.y + width * ring - width * p.own[1] * p.own[1]));
}

double steiners_roman(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 * p.y2 + p.x2 * p.z2 + p.y2 * p.z2 + p.x * p.y * p.z));
}

double strophoid(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double size = p.own[3] * p.own[3];
  return p.held(-((p.own[2] - p.x) * (p.y2 + p.z2) - size * p.own[1] * p.x2 - size * p.x2 * p.x));
}

double torus2(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double major2 = p.own[1] * p.own[1], minor2 = p.own[2] * p.own[2];
  const double sum = major2 + minor2, difference = major2 - minor2;
  return p.held(-(p.x2 * p.x2 + p.y2 * p.y2 + p.z2 * p.z2 + 2 * p.x2 * p.y2 + 2 * p.x2 * p.z2 + 2 * p.y2 * p.z2 -
                  2 * sum * p.x2 + 2 * difference * p.y2 - 2 * sum * p.z2 + difference * difference));
}

double torus_gumdrop(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  const double ring = p.y2 + p.z2;
  return p.held(-(4 * (p.x2 * p.x2 + ring * ring) + 17 * p.x2 * ring - 20 * (p.x2 + p.y2 + p.z2) + 17));
}

double umbrella(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.x2 - p.y * p.z * p.z));
}

double witch_of_agnesi(const double* arguments, const Evaluation&) {
  const Point p(arguments);
  return p.held(-(p.own[1] * (p.y - 1) + (p.x2 + p.z2) * p.y));
}

constexpr InternalFunction kRows[] = {
    {4, bicorn, 5},
    {5, bifolia, 5},
    {8, boy_surface, 5},
    {11, crossed_trough, 4},
    {12, cubic_saddle, 4},
    {13, cushion, 4},
    {14, devils_curve, 4},
    {16, dupin_cyclid, 9},
    {18, enneper, 4},
    {20, folium_surface, 6},
    {22, glob, 4},
    {23, heart, 4},
    {30, hunt_surface, 4},
    {31, hyperbolic_torus, 6},
    {33, kampyle_of_eudoxus, 6},
    {35, klein_bottle, 4},
    {36, kummer_surface_v1, 4},
    {37, kummer_surface_v2, 7},
    {38, lemniscate_of_gerono, 4},
    {41, mitre, 4},
    {42, nodal_cubic, 4},
    {43, cushion, 4},
    {44, ovals_of_cassini, 7},
    {45, paraboloid, 4},
    {46, parabolic_torus, 6},
    {48, pillow, 4},
    {49, piriform, 4},
    {54, quartic_paraboloid, 4},
    {55, quartic_saddle, 4},
    {56, quartic_cylinder, 6},
    {65, steiners_roman, 4},
    {66, strophoid, 7},
    {71, torus2, 6},
    {72, torus_gumdrop, 4},
    {73, umbrella, 4},
    {74, witch_of_agnesi, 5},
};

}  // namespace

std::span<const InternalFunction> internal_surfaces() { return kRows; }

}  // namespace firstlight::render
