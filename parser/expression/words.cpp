#include "parser/expression/words.h"

#include "parser/expression/arithmetic.h"
#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "parser/expression/functions.h"
#include "parser/expression/object_functions.h"
#include "parser/expression/string_functions.h"
#include "render/math/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace firstlight::parser {

namespace {

using render::Operation;
using render::Vec3;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// --- values of one number -------------------------------------------------------------------------------------------

/// A function of the number alone.
template <class Function>
constexpr Word::OfOne of_one(Function) {
  return [](Evaluator&, const Token&, double a) -> double { return Function{}(a); };
}

void refuse(Evaluator& in, const Token& word, const char* needed, double found) {
  in.fail(word.location, "'" + std::string(word.text) + "' needs a number " + needed + ", found " + number_text(found));
}

// acos and asin take what is outside their domain for its end.
double into_domain(Evaluator& in, const Token& word, double value) {
  if (value >= -1.0 && value <= 1.0) return value;
  in.warn(word.location, "'" + std::string(word.text) + "' of " + number_text(value) + ", which is outside -1 to 1");
  return std::clamp(value, -1.0, 1.0);
}

double arc_cosine(Evaluator& in, const Token& word, double value) { return std::acos(into_domain(in, word, value)); }
double arc_sine(Evaluator& in, const Token& word, double value) { return std::asin(into_domain(in, word, value)); }

double natural_logarithm(Evaluator& in, const Token& word, double value) {
  if (value <= 0.0) refuse(in, word, "above 0", value);
  return std::log(value);
}

double logarithm(Evaluator& in, const Token& word, double value) {
  if (value <= 0.0) refuse(in, word, "above 0", value);
  return std::log10(value);
}

double square_root(Evaluator& in, const Token& word, double value) {
  if (value < 0.0) refuse(in, word, "not below 0", value);
  return std::sqrt(value);
}

double open_stream(Evaluator& in, const Token&, double seed) {
  return static_cast<double>(in.random().open(to_int(seed)));
}

double next_random(Evaluator& in, const Token& word, double stream) {
  RandomStreams& random = in.random();
  if (!(stream > -1.0 && stream < static_cast<double>(random.count()))) {
    in.fail(word.location, "'rand' needs a stream that 'seed' has made, found " + number_text(stream));
  }
  return random.next(stream > 0.0 ? static_cast<std::size_t>(stream) : 0);
}

// --- values of two and more -----------------------------------------------------------------------------------------

double arc_tangent(Evaluator& in, const Token& word, double a, double b) {
  if (!is_true(a) && !is_true(b)) in.fail(word.location, "'atan2' of two zeros has no value");
  return std::atan2(a, b);
}

double quotient(Evaluator&, const Token&, double a, double b) { return to_int(a / b); }
double remainder(Evaluator&, const Token&, double a, double b) { return std::fmod(a, b); }

double power(Evaluator& in, const Token& word, double a, double b) {
  if (a == 0.0 && b == 0.0) in.fail(word.location, "'pow' of two zeros has no value");
  return std::pow(a, b);
}

constexpr Word::Fold kMax{[](double a, double b) { return std::max(a, b); }, false};
constexpr Word::Fold kMin{[](double a, double b) { return std::min(a, b); }, false};
constexpr Word::Fold kAnd{[](double a, double b) -> double { return to_int(a) & to_int(b); }, true};
constexpr Word::Fold kOr{[](double a, double b) -> double { return to_int(a) | to_int(b); }, true};
constexpr Word::Fold kXor{[](double a, double b) -> double { return to_int(a) ^ to_int(b); }, true};

// --- values of vectors ----------------------------------------------------------------------------------------------

/// Sums of products, as in POV-Ray, even where nothing turns: a negative zero becomes a positive one.
Vec3 turned(const Vec3& vector, const render::Transform& turn) { return turn.point(vector) + Vec3(0.0); }

Vec3 rotated_about(Evaluator& in, const Token& word, const Vec3& vector, const Vec3& axis, double degrees) {
  // POV-Ray goes on with what is not a number, and writes it with this sign.
  if (!(axis.dot(axis) > 0.0)) {
    in.warn(word.location, "'vaxis_rotate' about an axis without length, which is not a number");
    return Vec3(-std::numeric_limits<double>::quiet_NaN());
  }
  return turned(vector, render::Transform::rotation_about(axis, degrees));
}

Vec3 normalized(Evaluator& in, const Token& word, const Vec3& vector, const Vec3&, double) {
  const double length = std::sqrt(vector.dot(vector));
  if (length > 0.0) return vector * (1.0 / length);
  in.warn(word.location, "'vnormalize' of a vector without length");
  return Vec3(0.0);
}

/// Functions of vectors that have a value for all of them; a number is all components of theirs.
template <class Function>
constexpr auto of_vectors(Function) {
  return [](Evaluator&, const Token&, const Vec3& a, const Vec3& b, double) { return Vec3(Function{}(a, b)); };
}

constexpr Word::OfVectors kTurnAbout{rotated_about, true, true};
constexpr Word::OfVectors kCross{of_vectors([](const Vec3& a, const Vec3& b) { return a.cross(b); }), true, false};
constexpr Word::OfVectors kDot{of_vectors([](const Vec3& a, const Vec3& b) { return a.dot(b); }), true, false};
constexpr Word::OfVectors kLength{of_vectors([](const Vec3& a, const Vec3&) { return std::sqrt(a.dot(a)); }), false,
                                  false};
constexpr Word::OfVectors kNormalize{normalized, false, false};
constexpr Word::OfVectors kTurn{
    of_vectors([](const Vec3& a, const Vec3& b) { return turned(a, render::Transform::rotation(b)); }), true, false};

// --- the table ------------------------------------------------------------------------------------------------------

constexpr auto make_words() {
  using enum WordKind;
  using K = Keyword;
  return std::to_array<Word>({
      {K::none, other, {}, {}},
      // Constants.
      {K::false_, number, Word::Constant{0.0}, {}},
      {K::no, number, Word::Constant{0.0}, {}},
      {K::off, number, Word::Constant{0.0}, {}},
      {K::on, number, Word::Constant{1.0}, {}},
      {K::pi, number, Word::Constant{std::numbers::pi}, {}},
      {K::true_, number, Word::Constant{1.0}, {}},
      {K::yes, number, Word::Constant{1.0}, {}},
      {K::t, vector, Word::Unit{3, 4}, {}},
      {K::u, vector, Word::Unit{0, 2}, {}},
      {K::v, vector, Word::Unit{1, 2}, {}},
      {K::x, vector, Word::Unit{0, 3}, {}},
      {K::y, vector, Word::Unit{1, 3}, {}},
      {K::z, vector, Word::Unit{2, 3}, {}},
      // Functions of one number.
      {K::abs, number, of_one([](double a) { return std::abs(a); }), Operation::absolute},
      {K::acos, number, arc_cosine, Operation::arc_cosine},
      {K::acosh, number, of_one([](double a) { return std::acosh(a); }), Operation::hyperbolic_arc_cosine},
      {K::asin, number, arc_sine, Operation::arc_sine},
      {K::asinh, number, of_one([](double a) { return std::asinh(a); }), Operation::hyperbolic_arc_sine},
      {K::atan, number, of_one([](double a) { return std::atan(a); }), Operation::arc_tangent},
      {K::atanh, number, of_one([](double a) { return std::atanh(a); }), Operation::hyperbolic_arc_tangent},
      {K::ceil, number, of_one([](double a) { return std::ceil(a); }), Operation::ceiling},
      {K::cos, number, of_one([](double a) { return std::cos(a); }), Operation::cosine},
      {K::cosh, number, of_one([](double a) { return std::cosh(a); }), Operation::hyperbolic_cosine},
      {K::degrees, number, of_one([](double a) { return a / kRadiansPerDegree; }), {}},
      {K::exp, number, of_one([](double a) { return std::exp(a); }), Operation::exponential},
      {K::floor, number, of_one([](double a) { return std::floor(a); }), Operation::floor},
      {K::int_, number, of_one([](double a) { return to_int(a); }), Operation::integer},
      {K::ln, number, natural_logarithm, Operation::natural_logarithm},
      {K::log, number, logarithm, Operation::logarithm},
      {K::radians, number, of_one([](double a) { return a * kRadiansPerDegree; }), {}},
      {K::rand, number, next_random, {}},
      {K::seed, number, open_stream, {}},
      {K::sin, number, of_one([](double a) { return std::sin(a); }), Operation::sine},
      {K::sinh, number, of_one([](double a) { return std::sinh(a); }), Operation::hyperbolic_sine},
      {K::sqr, number, of_one([](double a) { return a * a; }), Operation::square},
      {K::sqrt, number, square_root, Operation::square_root},
      {K::tan, number, of_one([](double a) { return std::tan(a); }), Operation::tangent},
      {K::tanh, number, of_one([](double a) { return std::tanh(a); }), Operation::hyperbolic_tangent},
      // Functions of two numbers, and of any count.
      {K::atan2, number, arc_tangent, Operation::arc_tangent_of_two},
      {K::div, number, quotient, Operation::integer_quotient},
      {K::mod, number, remainder, Operation::remainder},
      {K::pow, number, power, {}},
      {K::bitwise_and, number, kAnd, {}},
      {K::bitwise_or, number, kOr, {}},
      {K::bitwise_xor, number, kXor, {}},
      {K::max, number, kMax, Operation::maximum},
      {K::min, number, kMin, Operation::minimum},
      // Functions of vectors.
      {K::vaxis_rotate, vector, kTurnAbout, {}},
      {K::vcross, vector, kCross, {}},
      {K::vdot, number, kDot, {}},
      {K::vlength, number, kLength, {}},
      {K::vnormalize, vector, kNormalize, {}},
      {K::vrotate, vector, kTurn, {}},
      // Words that read their arguments themselves, or have none.
      {K::asc, number, parse_asc, {}},
      {K::clock, number, parse_clock, {}},
      {K::clock_on, number, Word::Constant{0.0}, {}},
      {K::defined, number, parse_is_defined, {}},
      {K::dimension_size, number, parse_dimension_size, {}},
      {K::dimensions, number, parse_dimensions, {}},
      {K::file_exists, number, parse_file_exists, {}},
      {K::inside, number, parse_inside, {}},
      {K::max_extent, vector, parse_extent, {}},
      {K::min_extent, vector, parse_extent, {}},
      {K::now, number, parse_now, {}},
      {K::prod, number, refuse_loop, {}},
      {K::select, number, parse_select, {}},
      {K::strcmp, number, parse_strcmp, {}},
      {K::strlen, number, parse_strlen, {}},
      {K::sum, number, refuse_loop, {}},
      {K::trace, vector, parse_trace, {}},
      {K::val, number, parse_val, {}},
      {K::version, number, parse_version, {}},
      {K::vturbulence, vector, parse_vturbulence, {}},
      // Strings.
      {K::chr, string, parse_chr, {}},
      {K::concat, string, parse_concat, {}},
      {K::datetime, string, parse_datetime, {}},
      {K::str, string, parse_str, {}},
      {K::strlwr, string, parse_in_case, {}},
      {K::strupr, string, parse_in_case, {}},
      {K::substr, string, parse_substr, {}},
      {K::vstr, string, parse_vstr, {}},
      // Colours: color_expression.cpp.
      {K::alpha, color, {}, {}},
      {K::blue, color, {}, {}},
      {K::color, color, {}, {}},
      {K::filter, color, {}, {}},
      {K::gray, color, {}, {}},
      {K::green, color, {}, {}},
      {K::red, color, {}, {}},
      {K::rgb, color, {}, {}},
      {K::rgbf, color, {}, {}},
      {K::rgbft, color, {}, {}},
      {K::rgbt, color, {}, {}},
      {K::srgb, color, {}, {}},
      {K::srgbf, color, {}, {}},
      {K::srgbft, color, {}, {}},
      {K::srgbt, color, {}, {}},
      {K::transmit, color, {}, {}},
  });
}

constexpr auto kWords = make_words();

constexpr auto kRows = [] {
  std::array<std::uint8_t, kKeywordCount> rows{};
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    rows[static_cast<std::size_t>(kWords[i].keyword)] = static_cast<std::uint8_t>(i);
  }
  return rows;
}();

}  // namespace

const Word& word_of(Keyword word) { return kWords[kRows[static_cast<std::size_t>(word)]]; }

double fold_end(const Word::Fold& fold, double so_far) { return fold.is_whole ? to_int(so_far) : so_far; }

}  // namespace firstlight::parser
