// Shapes that are given by a formula and a few numbers.
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_shape.h"
#include "render/shape/julia_fractal.h"
#include "render/shape/ovus.h"
#include "render/shape/poly.h"
#include "render/shape/primitives.h"
#include "render/shape/quadric.h"
#include "render/shape/superellipsoid.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace firstlight::parser {

using render::JuliaFractalParameters;
using render::JuliaFunction;
using render::PolyParameters;
using render::ShapePtr;
using render::Vec3;

namespace {

int parse_order(Reader& reader, const Token& word) {
  const Token& at = reader.peek();
  const int order = integer(reader, "order of " + quoted(word));
  if (order < PolyParameters::kLowestOrder || order > PolyParameters::kHighestOrder) {
    reader.fail(at, "the order of " + quoted(word) + " must be from 2 to 35");
  }
  reader.skip_comma();
  return order;
}

/// `<` all coefficients `>`
PolyParameters parse_coefficients(Reader& reader, const Token& word, int order) {
  PolyParameters form;
  form.order = order;
  form.coefficients.resize(PolyParameters::coefficient_count(order));
  if (!reader.accept(Punctuation::less)) reader.fail_expected("'<' and the coefficients of " + quoted(word));
  const std::string what = "coefficient of " + quoted(word);
  for (double& coefficient : form.coefficients) {
    if (&coefficient != form.coefficients.data()) reader.skip_comma();
    coefficient = finite_number(reader, what);
  }
  if (!reader.accept(Punctuation::greater)) {
    reader.fail_expected("'>' after " + std::to_string(form.coefficients.size()) + " coefficients");
  }
  return form;
}

/// `(i, j, k): value` behind `xyz`.
void parse_term(Reader& reader, PolyParameters& form) {
  const Token& at = reader.peek();
  if (!reader.accept(Punctuation::left_paren)) reader.fail_expected("'(' and the three powers");
  std::array<int, 3> powers;
  for (int& power : powers) {
    power = integer(reader, "power");
    if (&power != &powers.back()) reader.skip_comma();
  }
  if (!reader.accept(Punctuation::right_paren)) reader.fail_expected("')' after the three powers");
  if (!reader.accept(Punctuation::colon)) reader.fail_expected("':' and the coefficient");
  const double value = finite_number(reader, "coefficient of 'polynomial'");
  for (int power : powers) {
    if (power < 0 || power > form.order) reader.fail(at, "a power of 'polynomial' is negative or above its order");
  }
  if (powers[0] + powers[1] + powers[2] > form.order) {
    reader.fail(at, "the powers of 'polynomial' add up to more than its order");
  }
  form.coefficients[PolyParameters::place(form.order, powers[0], powers[1], powers[2])] = value;
  reader.skip_comma();
}

std::optional<JuliaFunction> julia_function(Keyword word) {
  struct Row {
    Keyword word;
    JuliaFunction function;
  };
  static constexpr Row kRows[] = {
      {Keyword::sqr, JuliaFunction::square},
      {Keyword::cube, JuliaFunction::cube},
      {Keyword::exp, JuliaFunction::exponential},
      {Keyword::reciprocal, JuliaFunction::reciprocal},
      {Keyword::sin, JuliaFunction::sine},
      {Keyword::asin, JuliaFunction::arc_sine},
      {Keyword::sinh, JuliaFunction::hyperbolic_sine},
      {Keyword::asinh, JuliaFunction::hyperbolic_arc_sine},
      {Keyword::cos, JuliaFunction::cosine},
      {Keyword::acos, JuliaFunction::arc_cosine},
      {Keyword::cosh, JuliaFunction::hyperbolic_cosine},
      {Keyword::acosh, JuliaFunction::hyperbolic_arc_cosine},
      {Keyword::tan, JuliaFunction::tangent},
      {Keyword::atan, JuliaFunction::arc_tangent},
      {Keyword::tanh, JuliaFunction::hyperbolic_tangent},
      {Keyword::atanh, JuliaFunction::hyperbolic_arc_tangent},
      {Keyword::ln, JuliaFunction::natural_logarithm},
      {Keyword::pwr, JuliaFunction::power},
  };
  for (const Row& row : kRows) {
    if (row.word == word) return row.function;
  }
  return std::nullopt;
}

/// `(real, imaginary)`
std::complex<double> parse_exponent(Reader& reader) {
  if (!reader.accept(Punctuation::left_paren)) reader.fail_expected("'(' and the exponent's two parts");
  const double real = finite_number(reader, "exponent of 'pwr'");
  reader.skip_comma();
  const double imaginary = finite_number(reader, "exponent of 'pwr'");
  if (!reader.accept(Punctuation::right_paren)) reader.fail_expected("')' after the exponent's two parts");
  return {real, imaginary};
}

void parse_slice(Reader& reader, JuliaFractalParameters& set) {
  const Token& at = reader.peek();
  set.slice_normal = finite_vector4(reader, "slice of 'julia_fractal'");
  reader.skip_comma();
  set.slice_distance = finite_number(reader, "slice of 'julia_fractal'");
  const double length = std::sqrt(set.slice_normal.dot(set.slice_normal));
  if (length * length < kTinyLength) reader.fail(at, "the vector of 'slice' is zero");
  if (std::abs(set.slice_normal.w) < kTinyLength) reader.fail(at, "the last component of 'slice' is zero");
  set.slice_normal = set.slice_normal / length;
}

void parse_most_iterations(Reader& reader, JuliaFractalParameters& set) {
  const Token& at = reader.peek();
  const double number = std::max(1.0, std::floor(finite_number(reader, "max_iteration")));
  if (number > JuliaFractalParameters::kMostIterations) {
    reader.fail(at, "'max_iteration' of 'julia_fractal' must be at most " +
                        std::to_string(JuliaFractalParameters::kMostIterations));
  }
  set.most_iterations = static_cast<int>(number);
}

bool accept_julia_item(Reader& reader, JuliaFractalParameters& set) {
  if (reader.accept(Keyword::max_iteration)) {
    parse_most_iterations(reader, set);
  } else if (reader.accept(Keyword::slice)) {
    parse_slice(reader, set);
  } else if (reader.accept(Keyword::precision)) {
    set.precision = std::max(1.0, finite_number(reader, "precision"));
  } else if (reader.accept(Keyword::hypercomplex)) {
    set.algebra = JuliaFractalParameters::Algebra::hypercomplex;
  } else if (reader.accept(Keyword::quaternion)) {
    set.algebra = JuliaFractalParameters::Algebra::quaternion;
  } else if (const auto function = julia_function(reader.peek().keyword)) {
    reader.take();
    set.function = *function;
    if (set.function == JuliaFunction::power) set.exponent = parse_exponent(reader);
  } else {
    return false;
  }
  return true;
}

}  // namespace

ShapePtr parse_cubic(Reader& reader, const Token& word) {
  return render::make_poly(parse_coefficients(reader, word, 3));
}

ShapePtr parse_quartic(Reader& reader, const Token& word) {
  return render::make_poly(parse_coefficients(reader, word, 4));
}

ShapePtr parse_poly(Reader& reader, const Token& word) {
  const int order = parse_order(reader, word);
  return render::make_poly(parse_coefficients(reader, word, order));
}

ShapePtr parse_polynomial(Reader& reader, const Token& word) {
  PolyParameters poly;
  poly.order = parse_order(reader, word);
  poly.coefficients.resize(PolyParameters::coefficient_count(poly.order));
  while (reader.accept(Keyword::xyz)) parse_term(reader, poly);
  return render::make_poly(std::move(poly));
}

ShapePtr parse_quadric(Reader& reader, const Token&) {
  render::QuadricParameters quadric;
  for (Vec3* terms : {&quadric.square, &quadric.mixed, &quadric.linear}) {
    *terms = finite_vector(reader, "term of 'quadric'");
    reader.skip_comma();
  }
  quadric.constant = finite_number(reader, "constant of 'quadric'");
  return render::make_quadric(quadric);
}

ShapePtr parse_superellipsoid(Reader& reader, const Token&) {
  const render::Vec2 exponents = finite_vector2(reader, "exponent of 'superellipsoid'");
  return render::make_superellipsoid(exponents.x, exponents.y);
}

ShapePtr parse_ovus(Reader& reader, const Token& word) {
  const double bottom = finite_number(reader, "radius of 'ovus'");
  reader.skip_comma();
  const double top = finite_number(reader, "radius of 'ovus'");
  if (bottom < 0.0 || top < 0.0) reader.fail(word, "the radii of 'ovus' must be positive");
  if (top < 2.0 * bottom) return render::make_ovus(bottom, top);
  reader.warn(word, "the second radius of 'ovus' is not less than twice the first; the shape is a sphere");
  return render::make_sphere(Vec3(0.0, bottom, 0.0), top);
}

ShapePtr parse_julia_fractal(Reader& reader, const Token& word) {
  JuliaFractalParameters set;
  set.parameter = finite_vector4(reader, "parameter of 'julia_fractal'");
  while (accept_julia_item(reader, set)) {
  }
  if (set.algebra == JuliaFractalParameters::Algebra::quaternion && set.function != JuliaFunction::square &&
      set.function != JuliaFunction::cube) {
    reader.fail(
        word,
        "a 'julia_fractal' of this function must be 'hypercomplex': of a 'quaternion' there are only 'sqr' and 'cube'");
  }
  return render::make_julia_fractal(set);
}

}  // namespace firstlight::parser
