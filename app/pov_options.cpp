#include "app/pov_options.h"

#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace firstlight::app {
namespace {

std::optional<bool> parse_flag(std::string_view text) {
  const std::string word = lower(text);
  if (word == "on" || word == "true" || word == "yes" || word == "1") return true;
  if (word == "off" || word == "false" || word == "no" || word == "0") return false;
  return std::nullopt;
}

}  // namespace

void PovOptions::read_word(const std::string& word) {
  if (word.empty()) return;
  if (word[0] == '+' || word[0] == '-') return read_switch(word);
  const std::string small = lower(word);
  const std::size_t equals = small.find('=');
  const bool is_scene = small.ends_with(".pov");
  if (equals != std::string::npos && (!is_scene || is_setting(small.substr(0, equals)))) {
    read_setting(word);
  } else if (is_scene) {
    out_.options.scene = word;
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
  for (const SwitchRow& row : switch_rows()) {
    if (lower(std::string_view(word).substr(1)).starts_with(lower(row.letters)) &&
        (row.form == Form::integer || row.form == Form::number) && row.use != Use::ignored) {
      out_.errors.push_back(fmt::format("option '{}': expected {} right after {}{}, found '{}'", word,
                                        row.form == Form::integer ? "a whole number" : "a number", word[0], row.letters,
                                        word.substr(1 + row.letters.size())));
      return;
    }
  }
  if (word.size() == 2 && std::string_view("IiOoLl").find(word[1]) != std::string_view::npos) {
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
  if (name == "file_gamma") return read_file_gamma(word, value);
  if (name == "display_gamma") return;  // of a window
  if (read_file_setting(name, word, value)) return;
  const Setting* const setting = find_setting(name);
  if (setting == nullptr) {
    const std::string near = nearest(name, known_settings());
    out_.errors.push_back(
        fmt::format("unknown setting '{}'{}", word, near.empty() ? "" : "; the nearest known one is " + near + "="));
    return;
  }
  if (double* const number = number_of_setting(name)) {
    const auto parsed = parse<double>(value);
    if (!parsed) {
      out_.errors.push_back(fmt::format("setting '{}': '{}' is not a possible value", word, value));
      return;
    }
    *number = *parsed;
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
  // "Width=T2" must not become +WT2.
  const SwitchRow* const row = find_switch(std::string_view(as_switch).substr(1));
  if (row == nullptr || row->letters != setting->letters || !apply(as_switch))
    out_.errors.push_back(fmt::format("setting '{}': '{}' is not a possible value", word, value));
}

void PovOptions::read_file_gamma(const std::string& word, std::string_view value) {
  if (lower(value) == "srgb") {
    out_.options.file_gamma = 0.0;
  } else if (const auto gamma = parse<double>(value); gamma && *gamma > 0.0 && std::isfinite(*gamma)) {
    out_.options.file_gamma = *gamma;
  } else {
    out_.errors.push_back(fmt::format("setting '{}': expected sRGB or a number above 0, found '{}'", word, value));
  }
}

bool PovOptions::read_file_setting(const std::string& name, const std::string& word, const std::string& value) {
  const auto refuse = [&](std::string_view expected) {
    out_.errors.push_back(fmt::format("setting '{}': expected {}, found '{}'", word, expected, value));
  };
  if (name == "bits_per_color" || name == "bits_per_colour") {
    const auto bits = parse<int>(value);
    bits ? set_bits(word, *bits) : refuse("a whole number");
  } else if (name == "compression") {
    const auto compression = parse<int>(value);
    compression ? void(out_.options.compression = std::clamp(*compression, 0, 100)) : refuse("a whole number");
  } else if (name == "grayscale_output") {
    const auto flag = parse_flag(value);
    flag ? void(out_.options.grey = *flag) : refuse("on or off");
  } else if (name == "dither_method") {
    read_dither_method(word, value);
  } else {
    return false;
  }
  return true;
}

void PovOptions::set_bits(std::string_view word, int bits) {
  constexpr int kFewest = 5;
  constexpr int kMost = 16;
  out_.options.bits = std::clamp(bits, kFewest, kMost);
  if (out_.options.bits == bits) return;
  out_.warnings.push_back(
      fmt::format("{}: {} to {} bits per channel are possible, {} are used", word, kFewest, kMost, out_.options.bits));
}

void PovOptions::read_file_kind(std::string_view word, std::string_view kind) {
  const char type = out_.options.file_type;
  if (lower(kind) == "g") {
    out_.options.grey = true;
    return;
  }
  const auto bits = parse<int>(kind);
  if (!bits || *bits < 0) {
    out_.errors.push_back(fmt::format("option '{}': expected bits per channel, or g for gray, after '{}', found '{}'",
                                      word, word.substr(0, word.size() - kind.size()), kind));
    return;
  }
  if (const int fixed = fixed_bits_of(type); fixed == 0) {
    set_bits(word, *bits);
  } else if (type == 'J') {
    out_.warnings.push_back(fmt::format("{}: it is Compression={} that sets the quality of JPEG files", word, *bits));
  } else if (fixed != *bits && (fixed != 8 || *bits > 8)) {
    out_.warnings.push_back(fmt::format("{}: files of this type have {} bits per channel", word, fixed));
  }
}

void PovOptions::read_dither_method(std::string_view word, std::string_view name) {
  if (const auto method = render::find_dithering(name)) {
    dither_method_ = *method;
  } else {
    out_.errors.push_back(
        fmt::format("{}: there is no method '{}' of dithering; known are B2, B3, B4, D1, D2 and FS", word, name));
  }
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
  const SwitchRow* const row = find_switch(word.substr(1));
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
      if (parameter.size() > 1) read_file_kind(word, parameter.substr(1));
      break;
    }
    case Use::alpha:
      options.alpha = on;
      break;
    case Use::dither_method:
      read_dither_method(word, parameter);
      [[fallthrough]];
    case Use::dither:
      dithers_ = on;
      break;
    case Use::antialias:
    case Use::antialias_method:
    case Use::antialias_depth:
    case Use::antialias_gamma:
    case Use::jitter:
    case Use::block_size:
      apply_antialias(row->use, on, parameter);
      break;
    case Use::quality:
      options.quality.level = std::clamp(*parse<int>(parameter), 0, 11);
      break;
    case Use::remove_bounds:
      options.bounding.remove_bounds = on;
      break;
    case Use::split_unions:
      options.bounding.split_unions = on;
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

double* PovOptions::number_of_setting(std::string_view name) {
  if (name == "antialias_threshold") return &antialias_settings_.threshold;
  if (name == "jitter_amount") return &antialias_settings_.jitter_amount;
  return nullptr;
}

void PovOptions::apply_antialias(Use use, bool on, std::string_view parameter) {
  render::AntialiasSettings& settings = antialias_settings_;
  switch (use) {
    case Use::antialias:
      antialias_ = on;
      if (!parameter.empty()) settings.threshold = *parse<double>(parameter);
      break;
    case Use::antialias_method:
      settings.method = *parse<int>(parameter);
      break;
    case Use::antialias_depth:
      settings.depth = *parse<int>(parameter);
      break;
    case Use::antialias_gamma:
      settings.gamma = *parse<double>(parameter);
      break;
    case Use::jitter:
      settings.jitter = on;
      if (!parameter.empty()) settings.jitter_amount = *parse<double>(parameter);
      break;
    default:
      settings.block_size = *parse<int>(parameter);
      break;
  }
}

void PovOptions::finish_antialias() {
  if (!antialias_) return;
  render::AntialiasSettings& settings = antialias_settings_;
  const auto bring_within = [&](std::string_view name, auto& value, auto least, auto most) {
    const auto given = value;
    value = !(value >= least) ? least : std::min(value, most);
    if (value != given) {
      out_.warnings.push_back(fmt::format("{}={}: {} to {} is possible, {} is used", name, given, least, most, value));
    }
  };
  if (!(settings.gamma > 0.0 && std::isfinite(settings.gamma))) {
    out_.errors.push_back(fmt::format("Antialias_Gamma={}: expected a number above 0", settings.gamma));
  }
  if (settings.method < 1) {
    out_.warnings.push_back(
        fmt::format("Sampling_Method={}: no anti-aliasing; the methods are 1 and 2", settings.method));
    return;
  }
  bring_within("Sampling_Method", settings.method, 1, 2);
  bring_within("Antialias_Threshold", settings.threshold, 0.0, 1.0);
  bring_within("Antialias_Depth", settings.depth, 1, 9);
  bring_within("Jitter_Amount", settings.jitter_amount, 0.0, 1.0);
  bring_within("Render_Block_Size", settings.block_size, 4, std::numeric_limits<int>::max());
  out_.options.antialias = settings;
  check_samples();
}

// A threshold that no picture can show lets every pixel have all of its samples.
void PovOptions::check_samples() {
  constexpr double kShown = 1.0 / 255.0;
  constexpr double kMostSamples = 4294967296.0;
  const render::AntialiasSettings& settings = antialias_settings_;
  if (settings.threshold >= kShown) return;
  const double along = settings.method == 1 ? settings.depth : 1 << (settings.depth - 1);
  const double samples = along * along * out_.options.width * out_.options.height;
  if (samples <= kMostSamples) return;
  out_.errors.push_back(
      fmt::format("Antialias_Threshold={}: with Antialias_Depth={} the picture takes {:.2g} samples, and {:.2g} are "
                  "possible; choose "
                  "a higher threshold or a smaller depth",
                  settings.threshold, settings.depth, samples, kMostSamples));
}

void PovOptions::finish() {
  if (dithers_) out_.options.dithering = dither_method_;
  finish_antialias();
}

}  // namespace firstlight::app
