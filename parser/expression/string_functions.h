#pragma once

#include "parser/text/token.h"

#include <string>

namespace firstlight::parser {

class Evaluator;

// Functions that give strings: Word::StringReader.

/// `chr(code)`
std::string parse_chr(Evaluator& in, const Token& word);
std::string parse_concat(Evaluator& in, const Token& word);
/// `datetime(days since 2000, format)`, in universal time.
std::string parse_datetime(Evaluator& in, const Token& word);
/// `str(number, width, decimals)`
std::string parse_str(Evaluator& in, const Token& word);
/// `strlwr(string)`, `strupr(string)`
std::string parse_in_case(Evaluator& in, const Token& word);
/// `substr(string, first, count)`
std::string parse_substr(Evaluator& in, const Token& word);
/// `vstr(count, vector, separator, width, decimals)`
std::string parse_vstr(Evaluator& in, const Token& word);

}  // namespace firstlight::parser
