#include "render/scene/diagnostic.h"

#include "render/scene/escaped.h"

#include <fmt/format.h>

#include <algorithm>

namespace firstlight::render {
namespace {

const char* word(Diagnostic::Severity severity) {
  switch (severity) {
    case Diagnostic::Severity::debug:
      return "debug";
    case Diagnostic::Severity::note:
      return "note";
    case Diagnostic::Severity::warning:
      return "warning";
    case Diagnostic::Severity::error:
      return "error";
  }
  return "error";
}

/// Longest part of a source line that is shown, in bytes.
constexpr std::size_t kShown = 160;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

/// Makes a line that may hold anything fit for a terminal: tabs become one space, so that the caret stays below its
/// place, and bytes that would steer the terminal become '?'.
std::string printable(std::string text) {
  for (char& c : text) {
    if (c == '\t') c = ' ';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

/// Columns that `text` takes on a terminal, one a character.
std::size_t columns(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues_character));
}

/// The source line with the underlined place below it. A long line is cut to the part around the place.
std::string excerpt(const Diagnostic& d) {
  const std::string number = fmt::format("{:>3} | ", d.line);
  std::size_t begin = 0;
  std::size_t place = d.column > 0 ? std::min(d.column - 1, d.source_line.size()) : 0;
  if (place > kShown / 2 && d.source_line.size() > kShown) {
    begin = place - kShown / 2;
    while (begin < place && continues_character(d.source_line[begin])) ++begin;
  }
  std::size_t end = std::min(d.source_line.size(), begin + kShown);
  while (end < d.source_line.size() && end > begin && continues_character(d.source_line[end])) --end;
  const std::string shown = printable(d.source_line.substr(begin, end - begin));
  std::string text = "\n" + number + shown;
  if (d.column == 0) return text;

  place -= begin;
  const std::size_t length =
      std::min(std::max<std::size_t>(d.length, 1), std::max<std::size_t>(shown.size() - place, 1));
  const std::size_t width = std::max<std::size_t>(columns(shown.substr(place, length)), 1);
  return text + "\n" + std::string(number.size() - 2, ' ') + "| " + std::string(columns(shown.substr(0, place)), ' ') +
         "^" + std::string(width - 1, '~');
}

}  // namespace

std::string format(const Diagnostic& diagnostic) {
  std::string place = escaped(diagnostic.file);
  if (diagnostic.line > 0) place += fmt::format(":{}", diagnostic.line);
  if (diagnostic.line > 0 && diagnostic.column > 0) place += fmt::format(":{}", diagnostic.column);
  if (!place.empty()) place += ": ";
  std::string text = fmt::format("{}{}: {}", place, word(diagnostic.severity), escaped_lines(diagnostic.message));
  if (diagnostic.line > 0 && !diagnostic.source_line.empty()) text += excerpt(diagnostic);
  return text;
}

}  // namespace firstlight::render
