#pragma once

#include "parser/expression/arithmetic.h"
#include "parser/text/token.h"
#include "parser/text/value.h"
#include "render/math/color.h"
#include "render/math/vec.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace firstlight::parser {

class Evaluator;

// Numeric, vector and colour expressions. `terms` is the number of components that the place wants: a single number is
// promoted to that many equal ones as soon as it is read, which shows when vectors of different length meet
// (`<1, 2> + 1` is <2, 3, 1> where a vector of three is due). [POV-Ray 3.7 manual, "Vector Expressions"]

/// Parses an expression that may stand anywhere a value is due: sums of products, no comparisons but in parentheses.
Numbers parse_sum(Evaluator& in, std::uint8_t terms);
/// With comparisons, `&`, `|` and `?:` too, as in parentheses and behind colour words.
Numbers parse_full_expression(Evaluator& in, std::uint8_t terms);
double parse_float(Evaluator& in);
render::Vec3 parse_vector(Evaluator& in);
/// `(full expression)` that gives a single number.
double parse_condition(Evaluator& in);
/// `(number, number)`
std::pair<double, double> parse_two_numbers(Evaluator& in);
render::FilteredColor parse_color(Evaluator& in);

/// Whether an expression, a colour among them, can begin here; or one that can only give a single number.
bool at_expression(Evaluator& in);
bool at_float(Evaluator& in);

/// The value of a word that begins a number or vector, `word`, which has been taken. [functions.cpp]
Numbers parse_function(Evaluator& in, const Token& word);

// Operations that may find a mistake, whoever has read their operands.

/// Division by 0 is infinite, with a warning at the sign `mark`.
double divide(Evaluator& in, const Token& mark, double a, double b);
/// The component `.word`; fails where `numbers` has none of that name.
double pick_component(Evaluator& in, const Token& word, const Numbers& numbers);
/// "expected a float, found a vector expression", at the expression's first token.
[[noreturn]] void fail_components(Evaluator& in, const Location& at, std::string_view expected, const Numbers& found);

/// For messages.
std::string number_text(double value);

}  // namespace firstlight::parser
