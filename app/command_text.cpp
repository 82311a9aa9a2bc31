#include "app/command_text.h"

namespace firstlight::app {

std::string command_text(std::string_view program, std::span<const std::string> arguments) {
  std::string text(program);
  for (const std::string& word : arguments) {
    const bool plain = !word.empty() && word.find_first_of(" \t'\"\\;*?()[]<>|&$`#~") == std::string::npos;
    if (plain) {
      text += " " + word;
      continue;
    }
    text += " '";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += "'";
  }
  return text;
}

}  // namespace firstlight::app
