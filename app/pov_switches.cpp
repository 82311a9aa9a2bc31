#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace firstlight::app {
namespace {

constexpr std::string_view kPart = "rendering a part of the picture";
constexpr std::string_view kAnimation = "animation";
constexpr std::string_view kRadiosityFile = "radiosity in a file";

// In the order in which POV-Ray tries them: longer letters before their beginnings, a parameter before none.
constexpr SwitchRow kRows[] = {
    {"AG", Form::number, Use::antialias_gamma},
    {"AM", Form::integer, Use::antialias_method},
    {"A", Form::number, Use::antialias},
    {"A", Form::nothing, Use::antialias},
    {"BM", Form::integer, Use::ignored},
    {"BS", Form::integer, Use::block_size},
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
    {"J", Form::number, Use::jitter},
    {"J", Form::nothing, Use::jitter},
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
    {"R", Form::integer, Use::antialias_depth},
    {"SC", Form::number, Use::refused, kPart},
    {"SF", Form::number, Use::refused, kAnimation},
    {"SP", Form::integer, Use::ignored},
    {"SR", Form::number, Use::refused, kPart},
    {"STP", Form::integer, Use::refused, kAnimation},
    {"SU", Form::nothing, Use::split_unions},
    {"TH", Form::text, Use::dither_method},
    {"TH", Form::nothing, Use::dither},
    {"UA", Form::nothing, Use::alpha},
    {"UD", Form::nothing, Use::ignored},
    {"UF", Form::nothing, Use::refused_if_on, "rendering in fields"},
    {"UL", Form::nothing, Use::ignored},
    {"UO", Form::nothing, Use::ignored},
    {"UR", Form::nothing, Use::remove_bounds},
    {"UV", Form::nothing, Use::ignored},
    {"V", Form::nothing, Use::ignored},
    {"WL", Form::integer, Use::ignored},
    {"WT", Form::integer, Use::threads},
    {"W", Form::integer, Use::width},
    {"X", Form::text, Use::ignored},
    {"X", Form::nothing, Use::ignored},
};

// No switch has their meaning.
constexpr std::string_view kSettingsAlone[] = {"bits_per_color", "bits_per_colour", "compression", "declare",
                                               "display_gamma",  "dither_method",   "file_gamma",  "grayscale_output"};

constexpr Setting kSettings[] = {
    {"antialias", "A", true},
    {"antialias_depth", "R", false},
    {"antialias_gamma", "AG", false},
    {"antialias_threshold", "A", false},
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

}  // namespace

std::span<const SwitchRow> switch_rows() { return kRows; }

const SwitchRow* find_switch(std::string_view body) {
  const std::string letters = lower(body);
  for (const SwitchRow& row : kRows) {
    if (!letters.starts_with(lower(row.letters))) continue;
    if (fits(row.form, body.substr(row.letters.size()))) return &row;
  }
  return nullptr;
}

std::vector<std::string> known_switches() {
  std::vector<std::string> out;
  for (const SwitchRow& row : kRows) out.push_back(fmt::format("+{}", row.letters));
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

const Setting* find_setting(std::string_view name) {
  const auto* const setting = std::ranges::find(kSettings, name, &Setting::name);
  return setting == std::end(kSettings) ? nullptr : setting;
}

bool is_setting(std::string_view name) {
  return std::ranges::find(kSettingsAlone, name) != std::end(kSettingsAlone) || find_setting(name) != nullptr;
}

std::vector<std::string> known_settings() {
  std::vector<std::string> out(std::begin(kSettingsAlone), std::end(kSettingsAlone));
  for (const Setting& known : kSettings) out.emplace_back(known.name);
  return out;
}

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace firstlight::app
