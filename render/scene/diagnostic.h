#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace firstlight::render {

/// A message about a scene, with its place. `line` and `column` count from 1, column in bytes; 0: the message is about
/// the file as a whole.
struct Diagnostic {
  enum class Severity { debug, note, warning, error };

  Severity severity = Severity::error;
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::size_t length = 1;   ///< bytes to underline
  std::string message;      ///< "expected ..., found ..." without place or severity
  std::string source_line;  ///< the text of the line, without its end
  std::string subject;      ///< of a feature that cannot be rendered: its name; else empty
};

/// `file:line:column: error: message`, then the source line and a caret under the place.
std::string format(const Diagnostic& diagnostic);

using Diagnostics = std::vector<Diagnostic>;

}  // namespace firstlight::render
