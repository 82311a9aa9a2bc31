#pragma once

#include "app/options.h"

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
  void read_declare(std::string_view assignment);
  bool apply(std::string_view word);

  CommandLine& out_;
  std::string antialias_;  // the word that asked for it last, empty when off
};

}  // namespace firstlight::app
