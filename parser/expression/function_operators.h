#pragma once

// The operators that the body of a function may use, as a table.

#include "parser/text/token.h"
#include "render/function/instruction.h"

#include <cstddef>
#include <iterator>
#include <span>

namespace firstlight::parser {

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
