#include "parser/expression/functions.h"

#include "parser/expression/arithmetic.h"
#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"
#include "parser/expression/utf8.h"
#include "parser/expression/words.h"
#include "render/math/noise.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <variant>

namespace firstlight::parser {

namespace {

Numbers number(double value) { return single(value, 1); }

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

 private:
  Evaluator& in_;
  const Token& word_;
};

/// `(array`
std::shared_ptr<Array> take_array(Evaluator& in) {
  const Token& name = in.peek();
  const Value* value = in.peek_value();
  const auto* held = value != nullptr ? std::get_if<std::shared_ptr<Array>>(value) : nullptr;
  if (held == nullptr) in.fail(name.location, "expected an array, found " + in.describe_next());
  std::shared_ptr<Array> array = *held;
  in.take();
  return array;
}

/// `(string)`
std::string parse_text(Evaluator& in, const Token& word) {
  Call call(in, word);
  std::string text = parse_string(in);
  call.close();
  return text;
}

/// Reads what is behind a word, by the way that its row names.
struct Reading {
  Evaluator& in;
  const Token& word;

  Numbers operator()(std::monostate) const { return {}; }
  Numbers operator()(Word::StringReader) const { return {}; }
  Numbers operator()(const Word::Constant& constant) const { return number(constant.value); }
  Numbers operator()(const Word::Unit& vector) const { return unit(vector.component, vector.size); }
  Numbers operator()(Word::OfOne function) const { return number(function(in, word, parse_condition(in))); }
  Numbers operator()(Word::OfTwo function) const {
    const auto [a, b] = parse_two_numbers(in);
    return number(function(in, word, a, b));
  }
  Numbers operator()(const Word::Fold& fold) const {
    Call call(in, word);
    double result = call.number();
    while (call.more()) result = fold.join(result, call.number());
    call.close();
    return number(fold_end(fold, result));
  }
  Numbers operator()(const Word::OfVectors& function) const {
    Call call(in, word);
    const render::Vec3 first = call.vector();
    render::Vec3 second(0.0);
    double degrees = 0.0;
    if (function.takes_second) {
      call.comma();
      second = call.vector();
    }
    if (function.takes_degrees) {
      call.comma();
      degrees = call.number();
    }
    const render::Vec3 result = function.value(in, word, first, second, degrees);
    call.close();
    return word_kind(word.keyword) == WordKind::number ? number(result.x) : numbers_of(result);
  }
  Numbers operator()(Word::Reader read) const { return read(in, word); }
};

}  // namespace

Numbers parse_function(Evaluator& in, const Token& word) {
  return std::visit(Reading{in, word}, word_of(word.keyword).value);
}

Numbers parse_clock(Evaluator& in, const Token&) { return number(in.options().clock); }
Numbers parse_version(Evaluator& in, const Token&) { return number(in.language_version() / 100.0); }
Numbers parse_is_defined(Evaluator& in, const Token&) { return number(in.parse_defined() ? 1.0 : 0.0); }

Numbers parse_now(Evaluator&, const Token&) {
  using namespace std::chrono;
  const auto start = sys_days(year(2000) / January / 1);
  return number(duration<double, std::ratio<86400>>(system_clock::now() - start).count());
}

Numbers parse_select(Evaluator& in, const Token& word) {
  Call call(in, word);
  const double value = call.number();
  call.comma();
  const double below = call.number();
  call.comma();
  const double equal = call.number();
  const double above = call.more() ? call.number() : equal;
  call.close();
  return number(value < 0.0 ? below : value == 0.0 ? equal : above);
}

Numbers parse_dimensions(Evaluator& in, const Token& word) {
  Call call(in, word);
  const std::shared_ptr<Array> array = take_array(in);
  call.close();
  return number(static_cast<double>(array->sizes.size()));
}

Numbers parse_dimension_size(Evaluator& in, const Token& word) {
  Call call(in, word);
  const std::shared_ptr<Array> array = take_array(in);
  call.comma();
  const int dimension = to_int(call.number());
  call.close();
  const bool exists = dimension >= 1 && static_cast<std::size_t>(dimension) <= array->sizes.size();
  return number(exists ? array->sizes[static_cast<std::size_t>(dimension - 1)] : 0.0);
}

Numbers parse_asc(Evaluator& in, const Token& word) { return number(first_code_of(parse_text(in, word))); }
Numbers parse_file_exists(Evaluator& in, const Token& word) {
  return number(in.file_exists(parse_text(in, word)) ? 1.0 : 0.0);
}
Numbers parse_strlen(Evaluator& in, const Token& word) {
  return number(static_cast<double>(length_of(parse_text(in, word))));
}
Numbers parse_val(Evaluator& in, const Token& word) { return number(value_of(parse_text(in, word))); }

Numbers parse_strcmp(Evaluator& in, const Token& word) {
  Call call(in, word);
  const std::string left = parse_string(in);
  call.comma();
  const std::string right = parse_string(in);
  call.close();
  return number(compare_codes(left, right));
}

Numbers parse_vturbulence(Evaluator& in, const Token& word) {
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
  return numbers_of(render::dturbulence(point, octaves));
}

Numbers refuse_loop(Evaluator& in, const Token& word) {
  in.fail(word.location, "'" + std::string(word.text) + "' can only be used in the body of a function");
}

}  // namespace firstlight::parser
