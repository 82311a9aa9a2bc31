// Shapes that are made of a curve: turned, swept, filled, or thickened.
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_shape.h"
#include "render/shape/lathe.h"
#include "render/shape/polygon.h"
#include "render/shape/prism.h"
#include "render/shape/sor.h"
#include "render/shape/sphere_sweep.h"

#include <cmath>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::PrismParameters;
using render::ProfileSpline;
using render::ShapePtr;
using render::SphereSweepParameters;
using render::Vec2;
using render::Vec3;

namespace {

bool accept_spline(Reader& reader, ProfileSpline& spline) {
  if (reader.accept(Keyword::linear_spline)) {
    spline = ProfileSpline::linear;
  } else if (reader.accept(Keyword::quadratic_spline)) {
    spline = ProfileSpline::quadratic;
  } else if (reader.accept(Keyword::cubic_spline)) {
    spline = ProfileSpline::cubic;
  } else if (reader.accept(Keyword::bezier_spline)) {
    spline = ProfileSpline::bezier;
  } else {
    return false;
  }
  return true;
}

/// A number of points that goes with the spline. `fewest`: of linear, quadratic and cubic ones.
int curve_count(Reader& reader, const Token& word, ProfileSpline spline, const int (&fewest)[3]) {
  const Token& at = reader.peek();
  const bool bezier = spline == ProfileSpline::bezier;
  const int low = bezier ? 4 : fewest[static_cast<int>(spline)];
  const int count = point_count(reader, low, "points of " + quoted(word));
  if (bezier && count % 4 != 0) reader.fail(at, "a 'bezier_spline' takes four points for each of its parts");
  return count;
}

/// Points before the first that the curve goes through, and behind the last.
struct Controls {
  std::size_t before = 0, after = 0;
};

Controls controls_of(ProfileSpline spline) {
  switch (spline) {
    case ProfileSpline::quadratic:
      return {1, 0};
    case ProfileSpline::cubic:
      return {1, 1};
    default:
      return {0, 0};
  }
}

/// Where the last of several curves in a row begins that is not closed; points.size() when all are.
std::size_t open_curve(const std::vector<Vec2>& points, ProfileSpline spline) {
  const Controls controls = controls_of(spline);
  std::size_t start = controls.before;
  for (std::size_t i = start + 1; i < points.size(); ++i) {
    if (!same_point(points[i], points[start])) continue;
    start = i + 1 + controls.before + controls.after;
    i = start;
  }
  // a point too few to begin another curve says nothing
  return start + 1 < points.size() ? start : points.size();
}

/// The same of curves in Bezier parts of four points: each ends where the next begins, the last where the first began.
bool bezier_closed(const std::vector<Vec2>& points) {
  std::size_t start = 0;
  for (std::size_t i = 4; i < points.size(); i += 4) {
    if (same_point(points[i], points[i - 1])) continue;
    if (!same_point(points[i - 1], points[start])) return false;
    start = i;
  }
  return same_point(points.back(), points[start]);
}

/// Closes the curves, or tells that they cannot be.
bool close_prism(Reader& reader, const Token& word, PrismParameters& form) {
  if (form.spline == ProfileSpline::bezier) {
    if (bezier_closed(form.points)) return true;
  } else {
    const std::size_t start = open_curve(form.points, form.spline);
    if (start == form.points.size()) return true;
    if (form.spline == ProfileSpline::linear) {
      reader.warn(word, "the last curve of 'prism' is not closed; it is closed with a line");
      form.points.push_back(Vec2(form.points[start]));
      return true;
    }
  }
  reader.warn(word, "a curve of 'prism' is not closed; the prism is left out");
  return false;
}

}  // namespace

ShapePtr parse_lathe(Reader& reader, const Token& word) {
  render::LatheParameters lathe;
  while (accept_spline(reader, lathe.spline)) {
  }
  const int count = curve_count(reader, word, lathe.spline, {2, 3, 4});
  lathe.points = plane_points(reader, count, word);
  for (std::size_t i = 1; i + 1 < lathe.points.size(); ++i) {
    if (lathe.points[i].x < 0.0)
      reader.fail(word, "a point of 'lathe' lies behind the axis: its first number is negative");
  }
  return render::make_lathe(lathe);
}

ShapePtr parse_sor(Reader& reader, const Token& word) {
  render::SorParameters sor;
  const int count = point_count(reader, 4, "points of 'sor'");
  sor.points = plane_points(reader, count, word);
  for (std::size_t i = 0; i < sor.points.size(); ++i) {
    if (sor.points[i].x < 0.0)
      reader.fail(word, "a point of 'sor' lies behind the axis: its first number is negative");
    if (i > 1 && i + 1 < sor.points.size() && sor.points[i].y <= sor.points[i - 1].y) {
      reader.fail(word, "the points of 'sor' must rise: each second number must be above the one before");
    }
  }
  sor.open = reader.accept(Keyword::open);
  return render::make_sor(sor);
}

ShapePtr parse_prism(Reader& reader, const Token& word) {
  PrismParameters prism;
  for (;;) {
    if (reader.accept(Keyword::linear_sweep)) {
      prism.sweep = PrismParameters::Sweep::linear;
    } else if (reader.accept(Keyword::conic_sweep)) {
      prism.sweep = PrismParameters::Sweep::conic;
    } else if (!accept_spline(reader, prism.spline)) {
      break;
    }
  }
  prism.low = finite_number(reader, "height of 'prism'");
  reader.skip_comma();
  prism.high = finite_number(reader, "height of 'prism'");
  reader.skip_comma();
  if (prism.low > prism.high) std::swap(prism.low, prism.high);
  const int count = curve_count(reader, word, prism.spline, {3, 5, 6});
  prism.points = plane_points(reader, count, word);
  prism.open = reader.accept(Keyword::open);
  return close_prism(reader, word, prism) ? render::make_prism(prism) : nullptr;
}

ShapePtr parse_polygon(Reader& reader, const Token& word) {
  std::vector<Vec3> points;
  const int count = point_count(reader, 3, "points of 'polygon'");
  for (int i = 0; i < count; ++i) {
    reader.skip_comma();
    points.push_back(finite_vector(reader, "point of 'polygon'"));
  }
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!same_point(points[i], points[start])) continue;
    points[i] = points[start];
    start = ++i;
  }
  if (start + 1 < points.size()) {
    reader.warn(word, "the last line of 'polygon' is not closed; it is closed");
    points.push_back(Vec3(points[start]));
  }
  ShapePtr polygon = render::make_polygon(points);
  if (!polygon) reader.warn(word, "the points of 'polygon' are not in one plane or all on one line; it is left out");
  return polygon;
}

ShapePtr parse_sphere_sweep(Reader& reader, const Token&) {
  SphereSweepParameters sweep;
  if (reader.accept(Keyword::linear_spline)) {
    sweep.spline = SphereSweepParameters::Spline::linear;
  } else if (reader.accept(Keyword::cubic_spline)) {
    sweep.spline = SphereSweepParameters::Spline::cubic;
  } else if (reader.accept(Keyword::b_spline)) {
    sweep.spline = SphereSweepParameters::Spline::b_spline;
  } else {
    reader.fail_expected("'linear_spline', 'cubic_spline' or 'b_spline'");
  }
  reader.skip_comma();
  const int count = point_count(reader, sweep.spline == SphereSweepParameters::Spline::linear ? 2 : 4, "spheres");
  for (int i = 0; i < count; ++i) {
    SphereSweepParameters::Ball ball;
    reader.skip_comma();
    ball.center = finite_vector(reader, "center in 'sphere_sweep'");
    reader.skip_comma();
    ball.radius = finite_number(reader, "radius in 'sphere_sweep'");
    sweep.balls.push_back(ball);
  }
  if (reader.accept(Keyword::tolerance)) sweep.tolerance = finite_number(reader, "tolerance");
  return render::make_sphere_sweep(sweep);
}

}  // namespace firstlight::parser
