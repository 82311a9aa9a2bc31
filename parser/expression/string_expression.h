#pragma once

#include "parser/text/token.h"

#include <string>

namespace firstlight::parser {

class Evaluator;

// Strings are UTF-8; lengths and places in them count characters.

/// Whether a string expression begins here: a literal, a string function, or an identifier that holds a string.
bool at_string(Evaluator& in);
std::string parse_string(Evaluator& in);
/// A string that names a file. A literal is taken as it stands: a backslash in it is no escape.
std::string parse_path(Evaluator& in);
/// Contents of a string literal, its escapes replaced.
std::string unescape(Evaluator& in, const Token& literal);
/// Characters in `text`.
std::size_t length_of(const std::string& text);
/// The code of the first character, 0 for an empty string.
unsigned first_code_of(const std::string& text);
/// The difference of the first characters that differ, as strcmp() has it; 0 for equal strings.
int compare_codes(const std::string& left, const std::string& right);
/// The number that `text` begins with, 0 when it begins with none.
double value_of(const std::string& text);

}  // namespace firstlight::parser
