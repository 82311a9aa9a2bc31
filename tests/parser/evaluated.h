#pragma once

#include "tests/parser/scene_text.h"

#include <string>

namespace firstlight::parser {

/// The messages that `text` writes with #debug; the errors instead when there are any.
inline std::string debugged(const std::string& text) {
  const auto result = load(text);
  const std::string failed = errors(result);
  if (!failed.empty()) return "error: " + failed.substr(0, failed.size() - 1);
  std::string all;
  for (const auto& diagnostic : result.diagnostics) {
    if (diagnostic.severity == render::Diagnostic::Severity::debug) all += diagnostic.message;
  }
  return all;
}

/// The value of a float expression with `decimals`, as str() writes it.
inline std::string number(const std::string& expression, int decimals = 6) {
  return debugged("#declare Result = " + expression + ";\n#debug str(Result, 0, " + std::to_string(decimals) + ")");
}

/// The first `count` components of a vector or colour expression, with four decimals.
inline std::string vector(const std::string& expression, int count = 3) {
  return debugged("#declare Result = " + expression + ";\n#debug vstr(" + std::to_string(count) +
                  ", Result, \" \", 0, 4)");
}

}  // namespace firstlight::parser
