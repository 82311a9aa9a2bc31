// Shapes that are given by a formula and a few numbers.
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_shape.h"
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

using render::JuliaFractalForm;
using render::JuliaFunction;
using render::Object;
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
std::pair<double, double> parse_exponent(Reader& reader) {
  if (!reader.accept(Punctuation::left_paren)) reader.fail_expected("'(' and the exponent's two parts");
  std::pair<double, double> exponent;
  exponent.first = finite_number(reader, "exponent of 'pwr'");
  reader.skip_comma();
  exponent.second = finite_number(reader, "exponent of 'pwr'");
  if (!reader.accept(Punctuation::right_paren)) reader.fail_expected("')' after the exponent's two parts");
  return exponent;
}

void parse_slice(Reader& reader, JuliaFractalForm& form) {
  const Token& at = reader.peek();
  form.slice_normal = finite_vector4(reader, "slice of 'julia_fractal'");
  reader.skip_comma();
  form.slice_distance = finite_number(reader, "slice of 'julia_fractal'");
  const double length = std::sqrt(form.slice_normal.dot(form.slice_normal));
  if (length * length < kTinyLength) reader.fail(at, "the vector of 'slice' is zero");
  if (std::abs(form.slice_normal.w) < kTinyLength) reader.fail(at, "the last component of 'slice' is zero");
  form.slice_normal = form.slice_normal / length;
}

bool accept_julia_item(Reader& reader, JuliaFractalForm& form) {
  if (reader.accept(Keyword::max_iteration)) {
    form.most_iterations = std::max(1, static_cast<int>(std::floor(finite_number(reader, "max_iteration"))));
  } else if (reader.accept(Keyword::slice)) {
    parse_slice(reader, form);
  } else if (reader.accept(Keyword::precision)) {
    form.precision = std::max(1.0, finite_number(reader, "precision"));
  } else if (reader.accept(Keyword::hypercomplex)) {
    form.algebra = JuliaFractalForm::Algebra::hypercomplex;
  } else if (reader.accept(Keyword::quaternion)) {
    form.algebra = JuliaFractalForm::Algebra::quaternion;
  } else if (const auto function = julia_function(reader.peek().keyword)) {
    reader.take();
    form.function = *function;
    if (form.function == JuliaFunction::power) form.exponent = parse_exponent(reader);
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

void parse_julia_fractal(Reader& reader, SceneContext&, const Token& word, Object& object) {
  JuliaFractalForm form;
  form.parameter = finite_vector4(reader, "parameter of 'julia_fractal'");
  while (accept_julia_item(reader, form)) {
  }
  if (form.algebra == JuliaFractalForm::Algebra::quaternion && form.function != JuliaFunction::square &&
      form.function != JuliaFunction::cube) {
    reader.fail(
        word,
        "a 'julia_fractal' of this function must be 'hypercomplex': of a 'quaternion' there are only 'sqr' and 'cube'");
  }
  set_form(object, form);
}

}  // namespace firstlight::parser
