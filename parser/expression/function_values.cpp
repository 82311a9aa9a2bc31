#include "parser/expression/function_values.h"

#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "render/math/transform.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <numbers>

namespace firstlight::parser {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// acos and asin take what is outside their domain for its end.
double into_domain(Evaluator& in, const Token& word, double value) {
  if (value >= -1.0 && value <= 1.0) return value;
  in.warn(word.location, "'" + std::string(word.text) + "' of " + number_text(value) + ", which is outside -1 to 1");
  return std::clamp(value, -1.0, 1.0);
}

/// Sums of products, as in POV-Ray, even where nothing turns: a negative zero becomes a positive one.
render::Vec3 turned(const render::Vec3& vector, const render::Transform& turn) {
  return turn.point(vector) + render::Vec3(0.0);
}

}  // namespace

std::optional<double> constant_of(Keyword word) {
  switch (word) {
    case Keyword::pi:
      return std::numbers::pi;
    case Keyword::false_:
    case Keyword::no:
    case Keyword::off:
      return 0.0;
    case Keyword::true_:
    case Keyword::yes:
    case Keyword::on:
      return 1.0;
    default:
      return std::nullopt;
  }
}

int to_int(double value) {
  const double whole = std::trunc(value);
  return whole >= INT_MIN && whole <= INT_MAX ? static_cast<int>(whole) : INT_MIN;
}

CallForm call_form(Keyword word) {
  switch (word) {
    case Keyword::abs:
    case Keyword::acos:
    case Keyword::acosh:
    case Keyword::asin:
    case Keyword::asinh:
    case Keyword::atan:
    case Keyword::atanh:
    case Keyword::ceil:
    case Keyword::cos:
    case Keyword::cosh:
    case Keyword::degrees:
    case Keyword::exp:
    case Keyword::floor:
    case Keyword::int_:
    case Keyword::ln:
    case Keyword::log:
    case Keyword::radians:
    case Keyword::rand:
    case Keyword::seed:
    case Keyword::sin:
    case Keyword::sinh:
    case Keyword::sqr:
    case Keyword::sqrt:
    case Keyword::tan:
    case Keyword::tanh:
      return CallForm::number;
    case Keyword::atan2:
    case Keyword::div:
    case Keyword::mod:
    case Keyword::pow:
      return CallForm::two_numbers;
    case Keyword::max:
    case Keyword::min:
    case Keyword::bitwise_and:
    case Keyword::bitwise_or:
    case Keyword::bitwise_xor:
      return CallForm::fold;
    case Keyword::vaxis_rotate:
    case Keyword::vcross:
    case Keyword::vdot:
    case Keyword::vlength:
    case Keyword::vnormalize:
    case Keyword::vrotate:
      return CallForm::vectors;
    default:
      return CallForm::other;
  }
}

double value_of_number(Evaluator& in, const Token& word, double value) {
  const auto refuse = [&](const char* needed) {
    in.fail(word.location,
            "'" + std::string(word.text) + "' needs a number " + needed + ", found " + number_text(value));
  };
  switch (word.keyword) {
    case Keyword::abs:
      return std::abs(value);
    case Keyword::acos:
      return std::acos(into_domain(in, word, value));
    case Keyword::asin:
      return std::asin(into_domain(in, word, value));
    case Keyword::atan:
      return std::atan(value);
    case Keyword::acosh:
      return std::acosh(value);
    case Keyword::asinh:
      return std::asinh(value);
    case Keyword::atanh:
      return std::atanh(value);
    case Keyword::ceil:
      return std::ceil(value);
    case Keyword::cos:
      return std::cos(value);
    case Keyword::cosh:
      return std::cosh(value);
    case Keyword::degrees:
      return value / kRadiansPerDegree;
    case Keyword::exp:
      return std::exp(value);
    case Keyword::floor:
      return std::floor(value);
    case Keyword::int_:
      return to_int(value);
    case Keyword::ln:
      if (value <= 0.0) refuse("above 0");
      return std::log(value);
    case Keyword::log:
      if (value <= 0.0) refuse("above 0");
      return std::log10(value);
    case Keyword::radians:
      return value * kRadiansPerDegree;
    case Keyword::sin:
      return std::sin(value);
    case Keyword::sinh:
      return std::sinh(value);
    case Keyword::sqr:
      return value * value;
    case Keyword::sqrt:
      if (value < 0.0) refuse("not below 0");
      return std::sqrt(value);
    case Keyword::tan:
      return std::tan(value);
    case Keyword::tanh:
      return std::tanh(value);
    case Keyword::seed:
      return static_cast<double>(in.random().open(to_int(value)));
    default: {  // rand
      const int stream = to_int(value);
      if (stream < 0 || static_cast<std::size_t>(stream) >= in.random().count()) {
        in.fail(word.location, "'rand' needs a stream that 'seed' has made, found " + number_text(value));
      }
      return in.random().next(static_cast<std::size_t>(stream));
    }
  }
}

double value_of_two(Evaluator& in, const Token& word, double a, double b) {
  switch (word.keyword) {
    case Keyword::atan2:
      if (!is_true(a) && !is_true(b)) in.fail(word.location, "'atan2' of two zeros has no value");
      return std::atan2(a, b);
    case Keyword::div:
      return to_int(a / b);
    case Keyword::mod:
      return std::fmod(a, b);
    default:  // pow
      if (a == 0.0 && b == 0.0) in.fail(word.location, "'pow' of two zeros has no value");
      return std::pow(a, b);
  }
}

double fold(Keyword word, double so_far, double next) {
  switch (word) {
    case Keyword::max:
      return std::max(so_far, next);
    case Keyword::min:
      return std::min(so_far, next);
    case Keyword::bitwise_and:
      return to_int(so_far) & to_int(next);
    case Keyword::bitwise_or:
      return to_int(so_far) | to_int(next);
    default:  // bitwise_xor
      return to_int(so_far) ^ to_int(next);
  }
}

double fold_end(Keyword word, double so_far) {
  return word == Keyword::max || word == Keyword::min ? so_far : to_int(so_far);
}

bool takes_second_vector(Keyword word) { return word != Keyword::vlength && word != Keyword::vnormalize; }

render::Vec3 vector_of_vectors(Evaluator& in, const Token& word, const render::Vec3& first,
                               const render::Vec3& second, double degrees) {
  switch (word.keyword) {
    case Keyword::vnormalize: {
      const double length = std::sqrt(first.dot(first));
      if (length > 0.0) return first * (1.0 / length);
      in.warn(word.location, "'vnormalize' of a vector without length");
      return render::Vec3(0.0);
    }
    case Keyword::vcross:
      return first.cross(second);
    case Keyword::vrotate:
      return turned(first, render::Transform::rotation(second));
    default:  // vaxis_rotate
      // POV-Ray goes on with what is not a number, and writes it with this sign.
      if (!(second.dot(second) > 0.0)) {
        in.warn(word.location, "'vaxis_rotate' about an axis without length, which is not a number");
        return render::Vec3(-std::numeric_limits<double>::quiet_NaN());
      }
      return turned(first, render::Transform::rotation_about(second, degrees));
  }
}

double number_of_vectors(Keyword word, const render::Vec3& first, const render::Vec3& second) {
  return word == Keyword::vdot ? first.dot(second) : std::sqrt(first.dot(first));
}

}  // namespace firstlight::parser
