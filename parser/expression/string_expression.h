#pragma once

#include "parser/text/token.h"

#include <string>

namespace firstlight::parser {

class Evaluator;

/// Whether a string expression begins here: a literal, a string function, or an identifier that holds a string.
bool at_string(Evaluator& in);
std::string parse_string(Evaluator& in);
/// A string that names a file. A literal is taken as it stands: a backslash in it is no escape.
std::string parse_path(Evaluator& in);
/// Contents of a string literal, its escapes replaced.
std::string unescape(Evaluator& in, const Token& literal);

}  // namespace firstlight::parser
