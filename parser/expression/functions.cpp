// Words that are values or functions in expressions. [POV-Ray 3.7 manual, "Float Expressions", "Vector Expressions"]
#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "parser/expression/function_values.h"
#include "parser/expression/object_functions.h"
#include "parser/expression/string_expression.h"
#include "render/math/noise.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>

namespace firstlight::parser {

namespace {

Numbers vector_of(const render::Vec3& v) {
  Numbers result;
  result.values = {v.x, v.y, v.z, 0.0, 0.0};
  result.size = 3;
  return result;
}

/// The arguments of one function call.
class Call {
 public:
  Call(Evaluator& in, const Token& word) : in_(in), word_(word) {
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
  Evaluator& in_;
  const Token& word_;
};

double of_many_numbers(Evaluator& in, const Token& word) {
  Call call(in, word);
  double result = call.number();
  while (call.more()) result = fold(word.keyword, result, call.number());
  call.close();
  return fold_end(word.keyword, result);
}

// select(a, b, c): b below 0, else c; select(a, b, c, d): c at 0 and d above.
double select(Evaluator& in, const Token& word) {
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
double of_array(Evaluator& in, const Token& word) {
  Call call(in, word);
  const Token& name = in.peek();
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

double of_strings(Evaluator& in, const Token& word) {
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

render::Vec3 of_vectors(Evaluator& in, const Token& word) {
  Call call(in, word);
  const render::Vec3 first = call.vector();
  render::Vec3 second(0.0);
  double degrees = 0.0;
  if (takes_second_vector(word.keyword)) {
    call.comma();
    second = call.vector();
  }
  if (word.is(Keyword::vaxis_rotate)) {
    call.comma();
    degrees = call.number();
  }
  const render::Vec3 result = vector_of_vectors(in, word, first, second, degrees);
  call.close();
  return result;
}

// vturbulence(lambda, omega, octaves, point)
render::Vec3 turbulence(Evaluator& in, const Token& word) {
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

double of_vectors_to_number(Evaluator& in, const Token& word) {
  Call call(in, word);
  const render::Vec3 first = call.vector();
  render::Vec3 second(0.0);
  if (takes_second_vector(word.keyword)) {
    call.comma();
    second = call.vector();
  }
  call.close();
  return number_of_vectors(word.keyword, first, second);
}

double number_of(Evaluator& in, const Token& word) {
  if (const std::optional<double> constant = constant_of(word.keyword)) return *constant;
  switch (word.keyword) {
    case Keyword::clock:
      return in.options().clock;
    case Keyword::clock_on:
      return 0.0;
    case Keyword::version:
      return in.language_version() / 100.0;
    case Keyword::now:
      return days_since_2000();
    case Keyword::defined:
      return in.parse_defined() ? 1.0 : 0.0;
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
    case Keyword::inside:
      return parse_inside(in, word) ? 1.0 : 0.0;
    case Keyword::sum:
    case Keyword::prod:
      in.fail(word.location, "'" + std::string(word.text) + "' can only be used in the body of a function");
    default:
      break;
  }
  switch (call_form(word.keyword)) {
    case CallForm::two_numbers: {
      const auto [a, b] = parse_two_numbers(in);
      return value_of_two(in, word, a, b);
    }
    case CallForm::fold:
      return of_many_numbers(in, word);
    case CallForm::vectors:
      return of_vectors_to_number(in, word);
    default:
      return value_of_number(in, word, parse_condition(in));
  }
}

}  // namespace

Numbers parse_function(Evaluator& in, const Token& word) {
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
