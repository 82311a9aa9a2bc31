#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::parser {

/// Both programs print this behind each expression's number; no value has it in its text.
inline constexpr std::string_view kMark = "~";

/// A file of tests/parser as one scene: lines that begin with '#' are its own, with '!' too, without that sign.
struct Table {
  std::string scene;
  std::vector<std::string> expressions;
};

/// `#debug` of one expression of the table; its number stands before it.
inline std::string debug_line(const std::string& line, std::size_t number) {
  const std::string expression = line.substr(2);
  const std::string begin = "#debug concat(\"" + std::string(kMark) + std::to_string(number) + ":\", ";
  if (line[0] == '=') return "#declare Value = " + expression + ";\n" + begin + "str(Value, 0, 15), \";\\n\")\n";
  if (line[0] == '"') return begin + "\"[\", " + expression + ", \"];\\n\")\n";
  return "#declare Vector = " + expression + ";\n" + begin + "vstr(" + line[0] + ", Vector, \" \", 0, 15), \";\\n\")\n";
}

inline Table read_table(const std::string& name) {
  Table table;
  std::ifstream file(std::string(FIRSTLIGHT_SOURCE_DIR) + "/tests/parser/" + name);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '/') continue;
    if (line[0] == '#') {
      table.scene += line + "\n";
    } else if (line[0] == '!') {
      table.scene += line.substr(1) + "\n";
    } else {
      table.scene += "#undef Value #undef Vector " + debug_line(line, table.expressions.size());
      table.expressions.push_back(line);
    }
  }
  return table;
}

}  // namespace firstlight::parser
