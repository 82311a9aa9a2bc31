// Curves of the x-y plane as surfaces: drawn out along z, or turned about the y axis. The last three parameters are the
// same for all of them: whether to turn, the offset from the axis, and the angle of the curve.
// Source   The formulas as POV-Ray 3.7 evaluates them; the order of operations is its own, for rounding.
#include "render/function/internal.h"
#include "render/lanes/math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {
namespace {

/// A point of the plane, after the turn about the axis if there is one.
struct Place {
  double x, y, x2, y2;
  const double* own;  ///< the function's own parameters

  /// `turn`: the three parameters of the turn.
  Place(const double* p, const double* turn) : x(p[0]), y(p[1]), x2(x * x), y2(y * y), own(p + 3) {
    if (!(turn[0] > 0)) return;
    const double from_axis = std::sqrt(x2 + p[2] * p[2]) - turn[1];
    const double angle = turn[2] * (std::numbers::pi / 180.0);
    x = from_axis;
    if (angle != 0) {
      x = from_axis * steady::cosine(angle) - y * steady::sine(angle);
      y = from_axis * steady::sine(angle) + y * steady::cosine(angle);
    }
    x2 = x * x;
    y2 = y * y;
  }
  double held(double value, double limit = 10.0) const { return std::min(limit, std::max(own[0] * value, -limit)); }
};

double algbr_cyl1(const double* p, const Evaluation&) {
  const Place at(p, p + 5);
  const double x = std::abs(at.x);
  return -at.held(-(at.x2 * x - at.x2 + at.y2), at.own[1]);
}

double algbr_cyl2(const double* p, const Evaluation&) {
  const Place at(p, p + 5);
  return at.held(-(2 * at.x2 * at.x2 - 3 * at.x2 * at.y + at.y2 - 2 * at.y2 * at.y + at.y2 * at.y2), at.own[1]);
}

double algbr_cyl3(const double* p, const Evaluation&) {
  const Place at(p, p + 5);
  return at.held(-(at.x2 * at.x2 + at.x2 * at.y2 - 2 * at.x2 * at.y - at.x * at.y2 + at.y2), at.own[1]);
}

double algbr_cyl4(const double* p, const Evaluation&) {
  const Place at(p, p + 5);
  return at.held(-(at.x2 * at.x2 + at.y2 * at.y2 + 2 * at.x2 * at.y2 + 3 * at.x2 * at.y - at.y2 * at.y), at.own[1]);
}

double devils_curve_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 6);
  return at.held(-(at.x2 * (at.x2 - at.own[1] * at.own[1]) - at.y2 * (at.y2 - at.own[2] * at.own[2])));
}

double folium_surface_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 6);
  return at.held(-(at.y2 * (1 + (at.own[2] - 4 * at.own[1]) * at.x) + at.x2 * (1 + at.own[2])));
}

// POV-Ray multiplies both parameters where a square of the first is meant.
double kampyle_of_eudoxus_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 6);
  const double closeness = at.own[2] * at.own[2];
  return at.held(-(at.y2 - closeness * at.x2 * at.x2 + closeness * at.own[1] * at.own[2] * at.x2));
}

double lemniscate_of_gerono_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 6);
  const double width = at.own[2] * at.own[2];
  return at.held(-(at.y2 - width * at.own[1] * at.own[1] * at.x2 + width * at.x2 * at.x2));
}

double piriform_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 7);
  const double* own = at.own;
  return at.held(-(at.y * at.y - own[1] * own[3] * own[3] * at.x2 * at.x - own[2] * own[3] * own[3] * at.x2 * at.x2));
}

double strophoid_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 7);
  const double size = at.own[3] * at.own[3];
  return at.held(-((at.own[2] - at.x) * at.y2 - size * at.own[1] * at.x2 - size * at.x2 * at.x));
}

double witch_of_agnesi_2d(const double* p, const Evaluation&) {
  const Place at(p, p + 6);
  return at.held(-(at.own[1] * at.own[1] * at.y + at.x2 * at.y - at.own[2]));
}

constexpr InternalFunction kRows[] = {
    {0, algbr_cyl1, 8},
    {1, algbr_cyl2, 8},
    {2, algbr_cyl3, 8},
    {3, algbr_cyl4, 8},
    {15, devils_curve_2d, 9},
    {21, folium_surface_2d, 9},
    {34, kampyle_of_eudoxus_2d, 9},
    {39, lemniscate_of_gerono_2d, 9},
    {50, piriform_2d, 10},
    {67, strophoid_2d, 10},
    {75, witch_of_agnesi_2d, 9},
};

}  // namespace

std::span<const InternalFunction> internal_plane() { return kRows; }

}  // namespace firstlight::render
