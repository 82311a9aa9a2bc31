#pragma once

#include <string>
#include <string_view>

namespace firstlight::app {

// All that the program writes to its standard streams goes through here. Nothing throws, and what cannot be written to
// the error stream (a full disk, a reader or a terminal that has gone) is lost: a message is worth less than the picture.
// Control characters of what is said are shown as escapes. Threads: any.

/// To be called first: descriptors 0 to 2 that are closed are opened, so that no file of the scene becomes the error
/// stream, and a reader who has gone is an error and not the end of the program.
void secure_standard_streams();

/// Adds a line, or the lines of `text`, to the error stream.
void say(std::string_view text) noexcept;
/// A line that begins with "firstlight: error: ".
void say_error(std::string_view why) noexcept;
/// The same of several lines, which show a place in a text.
void say_error_in_lines(std::string_view why) noexcept;
/// A line that begins with "firstlight: warning: ".
void say_warning(std::string_view what) noexcept;
/// Says `text` of the scene, without an end of line of our own.
void say_piece(std::string_view text) noexcept;
/// For what steers the terminal: `text` as it is, or nothing when that would have to wait.
void draw(std::string_view text) noexcept;

/// Prints what the program was run for on the standard output. Returns empty, or why not all of it was written.
std::string print_result(std::string_view text);

}  // namespace firstlight::app
