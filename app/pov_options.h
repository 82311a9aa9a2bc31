#pragma once

#include "app/options.h"
#include "app/pov_switches.h"

#include <string>
#include <string_view>

namespace firstlight::app {

/// Reads POV-Ray's own forms into a CommandLine: switches (+W640, -A), settings (Width=640, Declare=A=1), and names of
/// files. What cannot change the picture is accepted in silence; what would, and is not available, is an error.
/// Source   POV-Ray 3.7 manual, "Command-Line and INI-File Options".
class PovOptions {
 public:
  explicit PovOptions(CommandLine& out) : out_(out) {}

  void read_word(const std::string& word);
  /// To be called after the last word.
  void finish();

 private:
  void read_switch(const std::string& word);
  void read_setting(const std::string& word);
  void read_file_gamma(const std::string& word, std::string_view value);
  void read_declare(std::string_view assignment);
  /// One of the settings of the file's numbers that no switch has; false when `name` is none.
  bool read_file_setting(const std::string& name, const std::string& word, const std::string& value);
  /// The option's bits per channel, or "g", after the letter of a file type.
  void read_file_kind(std::string_view word, std::string_view kind);
  void read_dither_method(std::string_view word, std::string_view name);
  void set_bits(std::string_view word, int bits);
  bool apply(std::string_view word);
  /// The number that a setting changes which, unlike the switch of the same meaning, does not also turn something on;
  /// else null.
  double* number_of_setting(std::string_view name);
  void apply_antialias(Use use, bool on, std::string_view parameter);
  void finish_antialias();
  void check_samples();

  CommandLine& out_;
  bool antialias_ = false;
  bool dithers_ = false;
  render::Dithering dither_method_ = render::Dithering::floyd_steinberg;
  render::AntialiasSettings antialias_settings_;
};

}  // namespace firstlight::app
