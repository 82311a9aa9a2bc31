#include "app/key_commands.h"

#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace firstlight::app {
namespace {

constexpr std::size_t kDigits = 9;
constexpr std::string_view kActions = " qsd?";

using Rows = std::vector<const priority::SchemeRow*>;

/// The schemes that can be changed to while it renders: all that have a queue.
Rows choices() {
  Rows rows;
  for (const priority::SchemeRow& row : priority::schemes()) {
    if (row.make != nullptr) rows.push_back(&row);
  }
  return rows;
}

/// The first whose name begins with `key`, null for a key that does something else.
const priority::SchemeRow* choice_of_letter(const Rows& rows, char key) {
  if (kActions.find(key) != std::string_view::npos) return nullptr;
  const auto row = std::ranges::find_if(rows, [&](const auto* scheme) { return scheme->name.starts_with(key); });
  return row == rows.end() ? nullptr : *row;
}

const priority::SchemeRow* choice_of(char key) {
  const Rows rows = choices();
  const auto digit = static_cast<std::size_t>(key - '1');
  return key >= '1' && digit < std::min(kDigits, rows.size()) ? rows[digit] : choice_of_letter(rows, key);
}

}  // namespace

bool KeyCommands::is_within_sequence(char key) {
  constexpr char kEscape = '\x1b';
  const Sequence before = sequence_;
  if (key == kEscape) {
    sequence_ = Sequence::begun;
  } else if (before == Sequence::begun) {
    // ESC [ ... letter, ESC O letter, or ESC and one key.
    sequence_ = key == '[' || key == 'O' ? Sequence::parameters : Sequence::none;
  } else if (before == Sequence::parameters && key >= '@' && key <= '~') {
    sequence_ = Sequence::none;
  }
  return before != Sequence::none || sequence_ != Sequence::none;
}

std::string KeyCommands::press(char key) {
  if (is_within_sequence(key)) return {};
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
      const std::string problem = desk_.save_to({});
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
  const priority::SchemeRow* const row = choice_of(key);
  if (row == nullptr) return {};
  const std::string problem = steering_.set_scheme(row->example);
  return problem.empty() ? fmt::format("scheme {}", row->example) : problem;
}

std::string keys_help() {
  std::string text =
      "  space     pause, continue\n"
      "  s         save the picture as it is\n"
      "  q         save it and leave\n"
      "  d         drop all boosts\n";
  const Rows rows = choices();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const char letter = rows[i]->name[0];
    std::string keys = i < kDigits ? fmt::format("{}", i + 1) : "";
    if (choice_of_letter(rows, letter) == rows[i]) keys += fmt::format("{}{}", keys.empty() ? "" : " ", letter);
    if (!keys.empty()) text += fmt::format("  {:<8}  scheme {}\n", keys, rows[i]->example);
  }
  return text;
}

}  // namespace firstlight::app
