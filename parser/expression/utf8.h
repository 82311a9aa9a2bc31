#pragma once

#include <cstddef>
#include <string>

namespace firstlight::parser {

// Strings of scenes are UTF-8; lengths and places in them count characters.

/// The character of a code, up to 0xffff.
std::string encode(unsigned code);
/// Byte offset of character `index`; the text's size beyond its end.
std::size_t offset_of(const std::string& text, std::size_t index);
/// Characters in `text`.
std::size_t length_of(const std::string& text);
/// The code of the first character, 0 for an empty string.
unsigned first_code_of(const std::string& text);
/// The difference of the first characters that differ, as strcmp() has it; 0 for equal strings.
int compare_codes(const std::string& left, const std::string& right);
/// The number that `text` begins with, 0 when it begins with none.
double value_of(const std::string& text);

}  // namespace firstlight::parser
