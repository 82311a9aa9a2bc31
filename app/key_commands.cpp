#include "app/key_commands.h"

#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace firstlight::app {
namespace {

constexpr std::size_t kDigits = 9;
constexpr std::string_view kActions = " qsd?";

/// The scheme whose name begins with `key`, the first in the table; a key that does something else is none.
std::optional<std::size_t> scheme_of_letter(char key) {
  if (kActions.find(key) != std::string_view::npos) return std::nullopt;
  const auto schemes = priority::schemes();
  const auto row = std::ranges::find_if(schemes, [&](const auto& scheme) { return scheme.name.starts_with(key); });
  if (row == schemes.end()) return std::nullopt;
  return static_cast<std::size_t>(row - schemes.begin());
}

std::optional<std::size_t> scheme_of(char key) {
  const std::size_t count = std::min(kDigits, priority::schemes().size());
  if (key >= '1' && key < '1' + static_cast<char>(count)) return static_cast<std::size_t>(key - '1');
  return scheme_of_letter(key);
}

}  // namespace

std::string KeyCommands::press(char key) {
  switch (key) {
    case ' ':
      if (steering_.paused()) {
        steering_.resume();
        return "continued";
      }
      steering_.pause();
      return "paused; space continues";
    case 'q':
      steering_.stop();
      return "stopping; the picture is written as it is";
    case 's': {
      const std::string problem = desk_.save({});
      return problem.empty() ? "the picture is saved as it is" : "not saved: " + problem;
    }
    case 'd':
      steering_.drop_all();
      return "no boosts";
    case '?':
      return keys_help();
    default:
      break;
  }
  const auto row = scheme_of(key);
  return row ? set_scheme(*row) : "";
}

std::string KeyCommands::set_scheme(std::size_t row) {
  const std::string_view text = priority::schemes()[row].example;
  const std::string problem = steering_.set_scheme(text);
  return problem.empty() ? fmt::format("scheme {}", text) : problem;
}

std::string keys_help() {
  std::string text =
      "  space     pause, continue\n"
      "  s         save the picture as it is\n"
      "  q         save it and leave\n"
      "  d         drop all boosts\n";
  const auto schemes = priority::schemes();
  for (std::size_t row = 0; row < schemes.size(); ++row) {
    const char letter = schemes[row].name[0];
    std::string keys = row < kDigits ? fmt::format("{}", row + 1) : "";
    if (scheme_of_letter(letter) == row) keys += fmt::format("{}{}", keys.empty() ? "" : " ", letter);
    if (!keys.empty()) text += fmt::format("  {:<8}  scheme {}\n", keys, schemes[row].example);
  }
  return text;
}

}  // namespace firstlight::app
