// Shapes that are made of a curve: turned, swept, filled, or thickened.
#include "parser/parse_common.h"
#include "parser/parse_form.h"

#include <cmath>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::Object;
using render::PrismForm;
using render::ProfileSpline;
using render::SphereSweepForm;
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
bool close_prism(Reader& reader, const Token& word, PrismForm& form) {
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

/// Whether the points are on one plane and not on one line, as far as POV-Ray asks.
bool spans_plane(const std::vector<Vec3>& points) {
  constexpr double kFlat = 1e-10;  // distance from the plane [POV-Ray 3.7, ZERO_TOLERANCE of its polygons]
  const Vec3 origin = points.front();
  std::size_t i = 1;
  while (i < points.size() && (points[i] - origin).length2() <= kTinyLength) ++i;
  if (i == points.size()) return false;
  const Vec3 first = points[i] - origin;
  Vec3 normal(0.0);
  for (++i; i < points.size(); ++i) {
    normal = first.cross(points[i] - origin);
    if ((points[i] - origin).length2() > kTinyLength && normal.length2() > kTinyLength) break;
  }
  if (i >= points.size()) return false;
  normal.normalize();
  for (const Vec3& point : points) {
    if (std::abs((point - origin).dot(normal)) > kFlat) return false;
  }
  return true;
}

}  // namespace

void parse_lathe(Reader& reader, SceneContext&, const Token& word, Object& object) {
  render::LatheForm form;
  while (accept_spline(reader, form.spline)) {
  }
  const int count = curve_count(reader, word, form.spline, {2, 3, 4});
  form.points = plane_points(reader, count, word);
  for (std::size_t i = 1; i + 1 < form.points.size(); ++i) {
    if (form.points[i].x < 0.0)
      reader.fail(word, "a point of 'lathe' lies behind the axis: its first number is negative");
  }
  set_form(object, std::move(form));
}

void parse_sor(Reader& reader, SceneContext&, const Token& word, Object& object) {
  render::SurfaceOfRevolutionForm form;
  const int count = point_count(reader, 4, "points of 'sor'");
  form.points = plane_points(reader, count, word);
  for (std::size_t i = 0; i < form.points.size(); ++i) {
    if (form.points[i].x < 0.0)
      reader.fail(word, "a point of 'sor' lies behind the axis: its first number is negative");
    if (i > 1 && i + 1 < form.points.size() && form.points[i].y <= form.points[i - 1].y) {
      reader.fail(word, "the points of 'sor' must rise: each second number must be above the one before");
    }
  }
  form.open = reader.accept(Keyword::open);
  set_form(object, std::move(form));
}

void parse_prism(Reader& reader, SceneContext&, const Token& word, Object& object) {
  PrismForm form;
  for (;;) {
    if (reader.accept(Keyword::linear_sweep)) {
      form.sweep = PrismForm::Sweep::linear;
    } else if (reader.accept(Keyword::conic_sweep)) {
      form.sweep = PrismForm::Sweep::conic;
    } else if (!accept_spline(reader, form.spline)) {
      break;
    }
  }
  form.low = finite_number(reader, "height of 'prism'");
  reader.skip_comma();
  form.high = finite_number(reader, "height of 'prism'");
  reader.skip_comma();
  if (form.low > form.high) std::swap(form.low, form.high);
  const int count = curve_count(reader, word, form.spline, {3, 5, 6});
  form.points = plane_points(reader, count, word);
  form.open = reader.accept(Keyword::open);
  if (close_prism(reader, word, form)) set_form(object, std::move(form));
}

void parse_polygon(Reader& reader, SceneContext&, const Token& word, Object& object) {
  render::PolygonForm form;
  const int count = point_count(reader, 3, "points of 'polygon'");
  for (int i = 0; i < count; ++i) {
    reader.skip_comma();
    form.points.push_back(finite_vector(reader, "point of 'polygon'"));
  }
  std::size_t start = 0;
  for (std::size_t i = 1; i < form.points.size(); ++i) {
    if (!same_point(form.points[i], form.points[start])) continue;
    form.points[i] = form.points[start];
    start = ++i;
  }
  if (start + 1 < form.points.size()) {
    reader.warn(word, "the last line of 'polygon' is not closed; it is closed");
    form.points.push_back(Vec3(form.points[start]));
  }
  if (spans_plane(form.points)) return set_form(object, std::move(form));
  reader.warn(word, "the points of 'polygon' are not in one plane or all on one line; it is left out");
}

void parse_sphere_sweep(Reader& reader, SceneContext&, const Token&, Object& object) {
  SphereSweepForm form;
  if (reader.accept(Keyword::linear_spline)) {
    form.spline = SphereSweepForm::Spline::linear;
  } else if (reader.accept(Keyword::cubic_spline)) {
    form.spline = SphereSweepForm::Spline::cubic;
  } else if (reader.accept(Keyword::b_spline)) {
    form.spline = SphereSweepForm::Spline::b_spline;
  } else {
    reader.fail_expected("'linear_spline', 'cubic_spline' or 'b_spline'");
  }
  reader.skip_comma();
  const int count = point_count(reader, form.spline == SphereSweepForm::Spline::linear ? 2 : 4, "spheres");
  for (int i = 0; i < count; ++i) {
    SphereSweepForm::Ball ball;
    reader.skip_comma();
    ball.center = finite_vector(reader, "center in 'sphere_sweep'");
    reader.skip_comma();
    ball.radius = finite_number(reader, "radius in 'sphere_sweep'");
    form.balls.push_back(ball);
  }
  if (reader.accept(Keyword::tolerance)) form.tolerance = finite_number(reader, "tolerance");
  set_form(object, std::move(form));
}

}  // namespace firstlight::parser
