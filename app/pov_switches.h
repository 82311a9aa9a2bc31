#pragma once

#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace firstlight::app {

/// Forms of what follows the letters of a switch.
enum class Form { nothing, integer, number, text };
/// Meanings of switches here.
enum class Use {
  width,
  height,
  input,
  output,
  library,
  threads,
  clock,
  file_type,
  write_picture,
  antialias,
  antialias_method,
  antialias_depth,
  antialias_gamma,
  jitter,
  block_size,
  quality,
  alpha,
  dither,
  dither_method,
  remove_bounds,
  split_unions,
  version,
  ignored,        ///< cannot change the finished picture
  refused,        ///< would change it
  refused_if_on,  ///< would change it with +, not with -
};

struct SwitchRow {
  std::string_view letters;
  Form form;
  Use use;
  std::string_view subject = {};  ///< of a refusal
};

/// Settings by their long names, and the switch that means the same.
struct Setting {
  std::string_view name;
  std::string_view letters;
  bool is_flag;  ///< its value is on or off
};

/// In the order in which POV-Ray tries them.
std::span<const SwitchRow> switch_rows();
/// The row that fits what stands after the sign of a switch, letters and parameter; null when none does.
const SwitchRow* find_switch(std::string_view body);
/// Switches as a user may have meant them, for suggestions: "+W", "+WT" ...
std::vector<std::string> known_switches();

/// `name` in lower case; null when there is no such setting.
const Setting* find_setting(std::string_view name);
/// Names of all settings, also of those that no switch stands for.
std::vector<std::string> known_settings();
/// Whether `name`, in lower case, is one of them.
bool is_setting(std::string_view name);

std::string lower(std::string_view text);

/// The whole of `text` as a number.
template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace firstlight::app
