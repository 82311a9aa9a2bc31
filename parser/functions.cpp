// Words that are values or functions in expressions. [POV-Ray 3.7 manual, "Float Expressions", "Vector Expressions"]
#include "parser/expression.h"
#include "parser/interpreter.h"
#include "parser/object_functions.h"
#include "parser/string_expression.h"
#include "render/math/noise.h"
#include "render/math/transform.h"

#include <algorithm>
#include <chrono>
#include <climits>
#include <cstdlib>
#include <numbers>

namespace firstlight::parser {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// POV-Ray cuts numbers to 32-bit integers; what does not fit becomes the lowest one, as its processors do it.
int to_int(double value) {
  const double whole = std::trunc(value);
  return whole >= INT_MIN && whole <= INT_MAX ? static_cast<int>(whole) : INT_MIN;
}

Numbers vector_of(const render::Vec3& v) {
  Numbers result;
  result.values = {v.x, v.y, v.z, 0.0, 0.0};
  result.size = 3;
  return result;
}

Numbers unit(std::size_t component, std::uint8_t size) {
  Numbers result;
  result.values[component] = 1.0;
  result.size = size;
  return result;
}

/// The arguments of one function call.
class Call {
 public:
  Call(Interpreter& in, const Token& word) : in_(in), word_(word) {
    in_.expect(Punctuation::left_paren, "after", word_.text);
  }
  double number() { return parse_float(in_); }
  render::Vec3 vector() { return parse_vector(in_); }
  void comma() {
    if (in_.peek().is(Punctuation::comma)) in_.take();
  }
  bool more() {
    if (!in_.peek().is(Punctuation::comma)) return false;
    in_.take();
    return true;
  }
  void close() { in_.expect(Punctuation::right_paren, "to close", word_.text); }
  [[noreturn]] void fail(std::string message) { in_.fail(word_.location, std::move(message)); }

 private:
  Interpreter& in_;
  const Token& word_;
};

// acos and asin take what is outside their domain for its end.
double into_domain(Interpreter& in, const Token& word, double value) {
  if (value >= -1.0 && value <= 1.0) return value;
  in.warn(word.location, "'" + std::string(word.text) + "' of " + number_text(value) + ", which is outside -1 to 1");
  return std::clamp(value, -1.0, 1.0);
}

double of_one_number(Interpreter& in, const Token& word) {
  const double value = parse_condition(in);
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

double of_two_numbers(Interpreter& in, const Token& word) {
  const auto [a, b] = parse_two_numbers(in);
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

double of_many_numbers(Interpreter& in, const Token& word) {
  Call call(in, word);
  double result = call.number();
  while (call.more()) {
    const double next = call.number();
    switch (word.keyword) {
      case Keyword::max:
        result = std::max(result, next);
        break;
      case Keyword::min:
        result = std::min(result, next);
        break;
      case Keyword::bitwise_and:
        result = to_int(result) & to_int(next);
        break;
      case Keyword::bitwise_or:
        result = to_int(result) | to_int(next);
        break;
      default:  // bitwise_xor
        result = to_int(result) ^ to_int(next);
        break;
    }
  }
  call.close();
  const bool whole = word.keyword != Keyword::max && word.keyword != Keyword::min;
  return whole ? to_int(result) : result;
}

// select(a, b, c): b below 0, else c; select(a, b, c, d): c at 0 and d above.
double select(Interpreter& in, const Token& word) {
  Call call(in, word);
  const double value = call.number();
  call.comma();
  const double below = call.number();
  call.comma();
  const double equal = call.number();
  const double above = call.more() ? call.number() : equal;
  call.close();
  return value < 0.0 ? below : value == 0.0 ? equal : above;
}

// dimensions(A), dimension_size(A, n)
double of_array(Interpreter& in, const Token& word) {
  Call call(in, word);
  const Token name = in.peek();
  const Value* value = in.peek_value();
  const auto* held = value != nullptr ? std::get_if<std::shared_ptr<Array>>(value) : nullptr;
  if (held == nullptr) in.fail(name.location, "expected an array, found " + in.describe_next());
  const std::shared_ptr<Array> array = *held;
  in.take();
  double result = static_cast<double>(array->sizes.size());
  if (word.is(Keyword::dimension_size)) {
    call.comma();
    const int dimension = to_int(call.number());
    const bool exists = dimension >= 1 && static_cast<std::size_t>(dimension) <= array->sizes.size();
    result = exists ? array->sizes[static_cast<std::size_t>(dimension - 1)] : 0.0;
  }
  call.close();
  return result;
}

double of_strings(Interpreter& in, const Token& word) {
  Call call(in, word);
  const std::string text = parse_string(in);
  double result = 0.0;
  switch (word.keyword) {
    case Keyword::asc:
      result = first_code_of(text);
      break;
    case Keyword::strlen:
      result = static_cast<double>(length_of(text));
      break;
    case Keyword::file_exists:
      result = in.file_exists(text) ? 1.0 : 0.0;
      break;
    case Keyword::strcmp: {
      call.comma();
      result = compare_codes(text, parse_string(in));
      break;
    }
    default:  // val: the number that the string begins with
      result = value_of(text);
      break;
  }
  call.close();
  return result;
}

double days_since_2000() {
  using namespace std::chrono;
  const auto start = sys_days(year(2000) / January / 1);
  return duration<double, std::ratio<86400>>(system_clock::now() - start).count();
}

render::Vec3 of_vectors(Interpreter& in, const Token& word) {
  Call call(in, word);
  const render::Vec3 first = call.vector();
  render::Vec3 result = first;
  if (word.is(Keyword::vnormalize)) {
    const double length = std::sqrt(first.dot(first));
    if (length > 0.0) {
      result = first * (1.0 / length);
    } else {
      in.warn(word.location, "'vnormalize' of a vector without length");
      result = render::Vec3(0.0);
    }
  } else {
    call.comma();
    const render::Vec3 second = call.vector();
    if (word.is(Keyword::vcross)) {
      result = first.cross(second);
    } else if (word.is(Keyword::vrotate)) {
      result = render::Transform::rotation(second).point(first);
    } else {  // vaxis_rotate
      call.comma();
      const double degrees = call.number();
      if (!(second.dot(second) > 0.0)) call.fail("'vaxis_rotate' needs an axis that has a length");
      result = render::Transform::rotation_about(second, degrees).point(first);
    }
  }
  call.close();
  return result;
}

// vturbulence(lambda, omega, octaves, point)
render::Vec3 turbulence(Interpreter& in, const Token& word) {
  constexpr int kMostOctaves = 10;
  Call call(in, word);
  render::Octaves octaves;
  octaves.lambda = static_cast<float>(call.number());
  call.comma();
  octaves.omega = static_cast<float>(call.number());
  call.comma();
  octaves.count = std::clamp(to_int(call.number()), 1, kMostOctaves);
  call.comma();
  const render::Vec3 point = call.vector();
  call.comma();
  call.close();
  return render::dturbulence(point, octaves);
}

double of_vectors_to_number(Interpreter& in, const Token& word) {
  Call call(in, word);
  const render::Vec3 first = call.vector();
  if (word.is(Keyword::vdot)) call.comma();
  const render::Vec3 second = word.is(Keyword::vdot) ? call.vector() : first;
  call.close();
  const double dot = first.dot(second);
  return word.is(Keyword::vdot) ? dot : std::sqrt(dot);
}

double number_of(Interpreter& in, const Token& word) {
  switch (word.keyword) {
    case Keyword::pi:
      return std::numbers::pi;
    case Keyword::clock:
      return in.options().clock;
    case Keyword::clock_on:
    case Keyword::false_:
    case Keyword::no:
    case Keyword::off:
      return 0.0;
    case Keyword::true_:
    case Keyword::yes:
    case Keyword::on:
      return 1.0;
    case Keyword::version:
      return in.language_version() / 100.0;
    case Keyword::now:
      return days_since_2000();
    case Keyword::defined:
      return in.parse_defined() ? 1.0 : 0.0;
    case Keyword::atan2:
    case Keyword::div:
    case Keyword::mod:
    case Keyword::pow:
      return of_two_numbers(in, word);
    case Keyword::max:
    case Keyword::min:
    case Keyword::bitwise_and:
    case Keyword::bitwise_or:
    case Keyword::bitwise_xor:
      return of_many_numbers(in, word);
    case Keyword::select:
      return select(in, word);
    case Keyword::dimensions:
    case Keyword::dimension_size:
      return of_array(in, word);
    case Keyword::asc:
    case Keyword::file_exists:
    case Keyword::strcmp:
    case Keyword::strlen:
    case Keyword::val:
      return of_strings(in, word);
    case Keyword::vdot:
    case Keyword::vlength:
      return of_vectors_to_number(in, word);
    case Keyword::inside:
      return parse_inside(in, word) ? 1.0 : 0.0;
    case Keyword::sum:
    case Keyword::prod:
      in.fail(word.location, "'" + std::string(word.text) + "' can only be used in the body of a function");
    default:
      return of_one_number(in, word);
  }
}

}  // namespace

Numbers parse_function(Interpreter& in, const Token& word) {
  switch (word.keyword) {
    case Keyword::x:
      return unit(0, 3);
    case Keyword::y:
      return unit(1, 3);
    case Keyword::z:
      return unit(2, 3);
    case Keyword::u:
      return unit(0, 2);
    case Keyword::v:
      return unit(1, 2);
    case Keyword::t:
      return unit(3, 4);
    case Keyword::vaxis_rotate:
    case Keyword::vcross:
    case Keyword::vnormalize:
    case Keyword::vrotate:
      return vector_of(of_vectors(in, word));
    case Keyword::vturbulence:
      return vector_of(turbulence(in, word));
    case Keyword::trace:
      return vector_of(parse_trace(in, word));
    case Keyword::min_extent:
    case Keyword::max_extent:
      return vector_of(parse_extent(in, word));
    default: {
      Numbers result;
      result.values[0] = number_of(in, word);
      return result;
    }
  }
}

}  // namespace firstlight::parser
