#pragma once

#include "parser/text/token.h"
#include "render/math/vec.h"

#include <optional>

namespace firstlight::parser {

class Evaluator;

// What the functions of the language give for arguments that are known, whoever has read them. `word` is the
// function's name, and where a mistake is told of. [POV-Ray 3.7 manual, "Float Functions", "Vector Functions"]

/// Of words that are numbers whatever the scene says: `pi`, `yes`, `off` ...
std::optional<double> constant_of(Keyword word);

/// POV-Ray cuts numbers to 32-bit integers; what does not fit becomes the lowest one, as its processors do it.
int to_int(double value);

/// How the arguments of a function stand in the text.
enum class CallForm : std::uint8_t {
  other,
  number,       ///< one full expression: sin, rand ...
  two_numbers,  ///< pow, atan2 ...
  fold,         ///< one or more numbers, taken in one after the other: max, bitwise_and ...
  vectors,      ///< one or two vectors, of vaxis_rotate a number too; gives a vector, of vdot and vlength a number
};
CallForm call_form(Keyword word);

double value_of_number(Evaluator& in, const Token& word, double value);
double value_of_two(Evaluator& in, const Token& word, double a, double b);
/// `so_far` is the first argument or what the earlier ones gave.
double fold(Keyword word, double so_far, double next);
/// What is made of it at the end.
double fold_end(Keyword word, double so_far);
bool takes_second_vector(Keyword word);
render::Vec3 vector_of_vectors(Evaluator& in, const Token& word, const render::Vec3& first,
                               const render::Vec3& second, double degrees);
double number_of_vectors(Keyword word, const render::Vec3& first, const render::Vec3& second);

}  // namespace firstlight::parser
