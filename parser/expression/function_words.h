#pragma once

// The functions and operators that the body of a function may use, as tables.

#include "parser/text/token.h"
#include "render/function/instruction.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>

namespace firstlight::parser {

/// A word of the language that is a function of numbers, and the operation it is.
struct FunctionWord {
  Keyword word;
  render::Operation operation;
};

inline constexpr FunctionWord kOfOne[] = {
    {Keyword::abs, render::Operation::absolute},
    {Keyword::acos, render::Operation::arc_cosine},
    {Keyword::acosh, render::Operation::hyperbolic_arc_cosine},
    {Keyword::asin, render::Operation::arc_sine},
    {Keyword::asinh, render::Operation::hyperbolic_arc_sine},
    {Keyword::atan, render::Operation::arc_tangent},
    {Keyword::atanh, render::Operation::hyperbolic_arc_tangent},
    {Keyword::ceil, render::Operation::ceiling},
    {Keyword::cos, render::Operation::cosine},
    {Keyword::cosh, render::Operation::hyperbolic_cosine},
    {Keyword::exp, render::Operation::exponential},
    {Keyword::floor, render::Operation::floor},
    {Keyword::int_, render::Operation::integer},
    {Keyword::ln, render::Operation::natural_logarithm},
    {Keyword::log, render::Operation::logarithm},
    {Keyword::sin, render::Operation::sine},
    {Keyword::sinh, render::Operation::hyperbolic_sine},
    {Keyword::sqr, render::Operation::square},
    {Keyword::sqrt, render::Operation::square_root},
    {Keyword::tan, render::Operation::tangent},
    {Keyword::tanh, render::Operation::hyperbolic_tangent},
};
inline constexpr FunctionWord kOfTwo[] = {
    {Keyword::atan2, render::Operation::arc_tangent_of_two},
    {Keyword::div, render::Operation::integer_quotient},
    {Keyword::mod, render::Operation::remainder},
};
inline constexpr FunctionWord kOfMany[] = {
    {Keyword::max, render::Operation::maximum},
    {Keyword::min, render::Operation::minimum},
};

inline const render::Operation* find(std::span<const FunctionWord> functions, Keyword word) {
  const auto found = std::ranges::find(functions, word, &FunctionWord::word);
  return found == functions.end() ? nullptr : &found->operation;
}

/// A mark between two values, and the operation it is.
struct Binary {
  Punctuation mark;
  render::Operation operation;
};

/// The operators of two values by rank, the weakest first.
inline constexpr Binary kOr[] = {{Punctuation::bar, render::Operation::logical_or}};
inline constexpr Binary kAnd[] = {{Punctuation::ampersand, render::Operation::logical_and}};
inline constexpr Binary kCompare[] = {{Punctuation::equal, render::Operation::equal},
                                      {Punctuation::not_equal, render::Operation::not_equal},
                                      {Punctuation::less, render::Operation::less},
                                      {Punctuation::less_equal, render::Operation::less_or_equal},
                                      {Punctuation::greater, render::Operation::greater},
                                      {Punctuation::greater_equal, render::Operation::greater_or_equal}};
inline constexpr Binary kSum[] = {{Punctuation::plus, render::Operation::add},
                                  {Punctuation::dash, render::Operation::subtract}};
inline constexpr Binary kProduct[] = {{Punctuation::star, render::Operation::multiply},
                                      {Punctuation::slash, render::Operation::divide}};
inline constexpr std::span<const Binary> kRanks[] = {kOr, kAnd, kCompare, kSum, kProduct};
inline constexpr std::size_t kRankCount = std::size(kRanks);

}  // namespace firstlight::parser
