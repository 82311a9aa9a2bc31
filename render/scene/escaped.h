#pragma once

#include <string>
#include <string_view>

namespace firstlight::render {

/// Text of a scene or a user for a message: control characters, which would steer a terminal, are shown as escapes such
/// as `\x1b` and `\n`. UTF-8 stays as it is, but for the control characters that it has.
std::string escaped(std::string_view text);
/// The same for text of several lines: ends of lines and tabs stay.
std::string escaped_lines(std::string_view text);

}  // namespace firstlight::render
