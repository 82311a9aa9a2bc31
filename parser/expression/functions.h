#pragma once

#include "parser/text/token.h"
#include "parser/text/value.h"

namespace firstlight::parser {

class Evaluator;

// Words of expressions that read their arguments in a way of their own: Word::Reader.

Numbers parse_clock(Evaluator& in, const Token& word);
Numbers parse_version(Evaluator& in, const Token& word);
/// `now`: days since the year 2000.
Numbers parse_now(Evaluator& in, const Token& word);
/// `defined(Name)`
Numbers parse_is_defined(Evaluator& in, const Token& word);
/// `select(a, b, c)`: b where a is below 0, else c; `select(a, b, c, d)`: c where it is 0, d above.
Numbers parse_select(Evaluator& in, const Token& word);
/// `dimensions(Array)`
Numbers parse_dimensions(Evaluator& in, const Token& word);
/// `dimension_size(Array, dimension)`
Numbers parse_dimension_size(Evaluator& in, const Token& word);
/// `asc(string)`: the code of its first character.
Numbers parse_asc(Evaluator& in, const Token& word);
Numbers parse_file_exists(Evaluator& in, const Token& word);
Numbers parse_strcmp(Evaluator& in, const Token& word);
Numbers parse_strlen(Evaluator& in, const Token& word);
/// `val(string)`: the number that it begins with.
Numbers parse_val(Evaluator& in, const Token& word);
/// `vturbulence(lambda, omega, octaves, point)`
Numbers parse_vturbulence(Evaluator& in, const Token& word);
/// `sum`, `prod`: only functions may have them.
Numbers refuse_loop(Evaluator& in, const Token& word);

}  // namespace firstlight::parser
