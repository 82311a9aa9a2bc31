#pragma once

#include "app/long_options.h"
#include "app/options.h"
#include "app/pov_options.h"

#include <cstddef>
#include <span>
#include <string>

namespace firstlight::app {

/// Reads the words of a command line, and of the .ini files that it names, in their order: what is said later counts.
class ArgumentReader {
 public:
  explicit ArgumentReader(CommandLine& out) : out_(out), long_options_(out), pov_(out) {}

  void read(std::span<const std::string> words);
  /// To be called after the last word.
  void finish() { pov_.finish(); }

 private:
  void read_long_option(const std::string& word, std::span<const std::string>& rest);
  /// Returns false when it is none of our own settings, nor looks like one that was meant.
  bool read_own_setting(const std::string& word);
  void read_ini_file(const std::string& word);

  CommandLine& out_;
  LongOptions long_options_;
  PovOptions pov_;
  int depth_ = 0;                  // of .ini files that name each other
  int ini_lines_ = 0;              // read so far
  std::size_t placed_errors_ = 0;  // up to here they say which file and line they are about
};

}  // namespace firstlight::app
