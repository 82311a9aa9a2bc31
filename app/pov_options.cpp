#include "app/pov_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <optional>

namespace firstlight::app {
namespace {

/// What follows the letters of a switch.
enum class Form { nothing, integer, number, text };
/// What the switch means here.
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
  quality,
  version,
  ignored,        ///< cannot change the finished picture
  refused,        ///< would change it
  refused_if_on,  ///< would change it with +, not with -
};

struct Row {
  std::string_view letters;
  Form form;
  Use use;
  std::string_view subject = {};  ///< of a refusal
};

constexpr std::string_view kPart = "rendering a part of the picture";
constexpr std::string_view kAnimation = "animation";
constexpr std::string_view kRadiosityFile = "radiosity in a file";

// In the order in which POV-Ray tries them: longer letters before their beginnings, a parameter before none.
constexpr Row kRows[] = {
    {"AG", Form::number, Use::ignored},
    {"AM", Form::integer, Use::ignored},
    {"A0", Form::number, Use::antialias},
    {"A", Form::number, Use::antialias},
    {"A", Form::nothing, Use::antialias},
    {"BM", Form::integer, Use::ignored},
    {"BS", Form::integer, Use::ignored},
    {"B", Form::nothing, Use::ignored},
    {"C", Form::nothing, Use::ignored},
    {"D", Form::text, Use::ignored},
    {"D", Form::nothing, Use::ignored},
    {"EC", Form::number, Use::refused, kPart},
    {"EF", Form::number, Use::refused, kAnimation},
    {"EP", Form::integer, Use::ignored},
    {"ER", Form::number, Use::refused, kPart},
    {"F", Form::text, Use::file_type},
    {"F", Form::nothing, Use::write_picture},
    {"GA", Form::nothing, Use::ignored},
    {"GD", Form::nothing, Use::ignored},
    {"GF", Form::nothing, Use::ignored},
    {"GP", Form::nothing, Use::ignored},
    {"GR", Form::nothing, Use::ignored},
    {"GS", Form::nothing, Use::ignored},
    {"GW", Form::nothing, Use::ignored},
    {"GI", Form::text, Use::refused, "writing an .ini file"},
    {"G", Form::text, Use::refused, "writing messages to a file"},
    {"HI", Form::text, Use::refused, "a header file included before the scene"},
    {"HR", Form::nothing, Use::ignored},
    {"H", Form::integer, Use::height},
    {"I", Form::text, Use::input},
    {"J", Form::number, Use::ignored},
    {"J", Form::nothing, Use::ignored},
    {"KC", Form::nothing, Use::refused_if_on, kAnimation},
    {"KI", Form::number, Use::refused, kAnimation},
    {"KFF", Form::integer, Use::refused, kAnimation},
    {"KFI", Form::integer, Use::refused, kAnimation},
    {"KF", Form::number, Use::refused, kAnimation},
    {"KLA", Form::nothing, Use::refused_if_on, kAnimation},
    {"K", Form::number, Use::clock},
    {"L", Form::text, Use::library},
    {"MB", Form::integer, Use::ignored},
    {"MB", Form::nothing, Use::ignored},
    {"MI", Form::integer, Use::ignored},
    {"MV", Form::number, Use::version},
    {"O", Form::text, Use::output},
    {"P", Form::nothing, Use::ignored},
    {"Q", Form::integer, Use::quality},
    {"RFI", Form::nothing, Use::refused_if_on, kRadiosityFile},
    {"RFO", Form::nothing, Use::refused_if_on, kRadiosityFile},
    {"RF", Form::text, Use::ignored},
    {"RS", Form::integer, Use::ignored},
    {"RP", Form::integer, Use::ignored},
    {"RTR", Form::nothing, Use::refused_if_on, "real-time rendering"},
    {"RVP", Form::nothing, Use::ignored},
    {"R", Form::integer, Use::ignored},
    {"SC", Form::number, Use::refused, kPart},
    {"SF", Form::number, Use::refused, kAnimation},
    {"SP", Form::integer, Use::ignored},
    {"SR", Form::number, Use::refused, kPart},
    {"STP", Form::integer, Use::refused, kAnimation},
    {"SU", Form::nothing, Use::ignored},
    {"TH", Form::text, Use::refused_if_on, "dithering"},
    {"TH", Form::nothing, Use::refused_if_on, "dithering"},
    {"UA", Form::nothing, Use::refused_if_on, "a transparent background"},
    {"UD", Form::nothing, Use::ignored},
    {"UF", Form::nothing, Use::refused_if_on, "rendering in fields"},
    {"UL", Form::nothing, Use::ignored},
    {"UO", Form::nothing, Use::ignored},
    {"UR", Form::nothing, Use::ignored},
    {"UV", Form::nothing, Use::ignored},
    {"V", Form::nothing, Use::ignored},
    {"WL", Form::integer, Use::ignored},
    {"WT", Form::integer, Use::threads},
    {"W", Form::integer, Use::width},
    {"X", Form::text, Use::ignored},
    {"X", Form::nothing, Use::ignored},
};

/// Settings by their long names, and the switch that means the same.
struct Setting {
  std::string_view name;
  std::string_view letters;
  bool is_flag;  ///< its value is on or off
};

constexpr Setting kSettings[] = {
    {"antialias", "A", true},
    {"antialias_depth", "R", false},
    {"antialias_gamma", "AG", false},
    {"bounding", "B", true},
    {"bounding_method", "BM", false},
    {"bounding_threshold", "MB", false},
    {"clock", "K", false},
    {"continue_trace", "C", true},
    {"cyclic_animation", "KC", true},
    {"display", "D", true},
    {"dither", "TH", true},
    {"end_column", "EC", false},
    {"end_row", "ER", false},
    {"final_clock", "KF", false},
    {"final_frame", "KFF", false},
    {"height", "H", false},
    {"high_reproducibility", "HR", true},
    {"include_header", "HI", false},
    {"initial_clock", "KI", false},
    {"initial_frame", "KFI", false},
    {"input_file_name", "I", false},
    {"jitter", "J", true},
    {"jitter_amount", "J", false},
    {"library_path", "L", false},
    {"output_alpha", "UA", true},
    {"output_file_name", "O", false},
    {"output_file_type", "F", false},
    {"output_to_file", "F", true},
    {"pause_when_done", "P", true},
    {"quality", "Q", false},
    {"remove_bounds", "UR", true},
    {"render_block_size", "BS", false},
    {"sampling_method", "AM", false},
    {"split_unions", "SU", true},
    {"start_column", "SC", false},
    {"start_row", "SR", false},
    {"test_abort", "X", true},
    {"verbose", "V", true},
    {"version", "MV", false},
    {"warning_level", "WL", false},
    {"width", "W", false},
    {"work_threads", "WT", false},
};

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

bool fits(Form form, std::string_view parameter) {
  switch (form) {
    case Form::nothing:
      return parameter.empty();
    case Form::integer:
      return parse<int>(parameter).has_value();
    case Form::number:
      return parse<double>(parameter).has_value();
    case Form::text:
      return !parameter.empty();
  }
  return false;
}

const Row* find_row(std::string_view body) {
  const std::string letters = lower(body);
  for (const Row& row : kRows) {
    if (!letters.starts_with(lower(row.letters))) continue;
    // "A0" keeps its digit: it is the beginning of the number.
    const std::size_t begin = row.letters == "A0" ? 1 : row.letters.size();
    if (fits(row.form, body.substr(begin))) return &row;
  }
  return nullptr;
}

std::optional<bool> parse_flag(std::string_view text) {
  const std::string word = lower(text);
  if (word == "on" || word == "true" || word == "yes" || word == "1") return true;
  if (word == "off" || word == "false" || word == "no" || word == "0") return false;
  return std::nullopt;
}

}  // namespace

std::vector<std::string> known_switches() {
  std::vector<std::string> out;
  for (const Row& row : kRows) out.push_back(fmt::format("+{}", row.letters));
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

void PovOptions::read_word(const std::string& word) {
  if (word.empty()) return;
  if (word[0] == '+' || word[0] == '-') return read_switch(word);
  const std::string small = lower(word);
  if (small.ends_with(".ini") || small.find(".ini[") != std::string::npos) {
    out_.errors.push_back(
        fmt::format("{}: settings are not read from .ini files; give them on the command line", word));
  } else if (word.find('=') != std::string::npos) {
    read_setting(word);
  } else if (word.back() == '/') {
    out_.options.library_paths.push_back(word);
  } else {
    out_.options.scene = word;
  }
}

void PovOptions::read_switch(const std::string& word) {
  if (apply(word)) return;
  const std::string near = nearest(word, known_switches());
  // Known letters with a parameter of the wrong kind deserve another message than unknown ones.
  for (const Row& row : kRows) {
    if (lower(std::string_view(word).substr(1)).starts_with(lower(row.letters)) &&
        (row.form == Form::integer || row.form == Form::number) && row.use != Use::ignored) {
      out_.errors.push_back(fmt::format("option '{}': expected {} right after {}{}, found '{}'", word,
                                        row.form == Form::integer ? "a whole number" : "a number", word[0], row.letters,
                                        word.substr(1 + row.letters.size())));
      return;
    }
  }
  if ((word == "+I" || word == "-I" || word == "+O" || word == "-O" || word == "+L" || word == "-L")) {
    out_.errors.push_back(fmt::format("option '{}': expected a name right after it, without a space", word));
    return;
  }
  out_.errors.push_back(
      fmt::format("unknown option '{}'{}", word,
                  near.empty() ? std::string("; --help lists all") : "; the nearest known one is " + near));
}

void PovOptions::read_setting(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string name = lower(std::string_view(word).substr(0, equals));
  const std::string value = word.substr(equals + 1);
  if (name == "declare") return read_declare(value);
  const auto* const setting = std::ranges::find(kSettings, name, &Setting::name);
  if (setting == std::end(kSettings)) {
    std::vector<std::string> names{"declare"};
    for (const Setting& known : kSettings) names.emplace_back(known.name);
    const std::string near = nearest(name, names);
    out_.errors.push_back(
        fmt::format("unknown setting '{}'{}", word, near.empty() ? "" : "; the nearest known one is " + near + "="));
    return;
  }
  std::string as_switch;
  if (setting->is_flag) {
    const auto flag = parse_flag(value);
    if (!flag) {
      out_.errors.push_back(fmt::format("setting '{}': expected on or off, found '{}'", word, value));
      return;
    }
    as_switch = fmt::format("{}{}", *flag ? '+' : '-', setting->letters);
  } else {
    as_switch = fmt::format("+{}{}", setting->letters, value);
  }
  if (!apply(as_switch)) out_.errors.push_back(fmt::format("setting '{}': '{}' is not a possible value", word, value));
}

void PovOptions::read_declare(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string name(assignment.substr(0, equals));
  const bool is_name = !name.empty() && (std::isalpha(static_cast<unsigned char>(name[0])) || name[0] == '_') &&
                       std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (equals == std::string_view::npos || !is_name || !parse<double>(assignment.substr(equals + 1))) {
    out_.errors.push_back(fmt::format("declare={}: expected an identifier, '=' and a number", assignment));
    return;
  }
  out_.options.declares.emplace_back(name, std::string(assignment.substr(equals + 1)));
}

bool PovOptions::apply(std::string_view word) {
  const bool on = word[0] == '+';
  const Row* const row = find_row(word.substr(1));
  if (row == nullptr) return false;
  const std::string_view parameter = word.substr(1 + row->letters.size());
  Options& options = out_.options;
  const auto size = [&](int& target) {
    target = *parse<int>(parameter);
    if (target < 1)
      out_.errors.push_back(fmt::format("option '{}': a picture is at least one pixel wide and high", word));
  };
  switch (row->use) {
    case Use::width:
      size(options.width);
      break;
    case Use::height:
      size(options.height);
      break;
    case Use::input:
      options.scene = parameter;
      break;
    case Use::output:
      options.output = parameter;
      break;
    case Use::library:
      options.library_paths.emplace_back(parameter);
      break;
    case Use::threads:
      options.threads = *parse<int>(parameter);
      if (options.threads < 1) out_.errors.push_back(fmt::format("option '{}': at least one thread is needed", word));
      break;
    case Use::clock:
      options.clock = *parse<double>(parameter);
      break;
    case Use::write_picture:
      options.write_picture = on;
      break;
    case Use::file_type: {
      options.write_picture = on;
      options.file_type = static_cast<char>(std::toupper(static_cast<unsigned char>(parameter[0])));
      if (parameter.size() == 1) break;
      const auto bits = parse<int>(parameter.substr(1));
      if (!bits) return false;
      options.bits = *bits;
      break;
    }
    case Use::antialias:
      antialias_ = on ? word : std::string_view();
      break;
    case Use::quality:
      if (const int quality = *parse<int>(parameter); quality < 9 || quality > 11) {
        out_.errors.push_back(fmt::format("option '{}': a quality below full (9) is not available", word));
      }
      break;
    case Use::version:
      if (*parse<double>(parameter) != 3.7) {
        out_.errors.push_back(fmt::format("option '{}': only language version 3.7 can be set from outside", word));
      }
      break;
    case Use::ignored:
      break;
    case Use::refused_if_on:
      if (!on) break;
      [[fallthrough]];
    case Use::refused:
      out_.errors.push_back(fmt::format("option '{}': {} is not available", word, row->subject));
      break;
  }
  return true;
}

void PovOptions::finish() {
  if (!antialias_.empty()) {
    out_.errors.push_back(
        fmt::format("option '{}': anti-aliasing is not available; give -A to render without", antialias_));
  }
}

}  // namespace firstlight::app
