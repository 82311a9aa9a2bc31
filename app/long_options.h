#pragma once

#include "app/options.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace firstlight::app {

/// Our own options, in their three forms: "--queue-memory 16M" on a command line, and "Queue_Memory=16M" there or in an
/// .ini file. The last word on an option counts, but boosts add up.
class LongOptions {
 public:
  explicit LongOptions(CommandLine& out);
  ~LongOptions();
  LongOptions(const LongOptions&) = delete;
  LongOptions& operator=(const LongOptions&) = delete;

  bool knows(const std::string& name) const { return find(name) != nullptr; }
  bool takes_value(const std::string& name) const;
  /// "--name", or "--name=value".
  void read_word(const std::string& word);
  /// The text of --help about them.
  std::string help() const;
  /// "--scheme", ...
  std::vector<std::string> names() const;

 private:
  const CLI::Option* find(const std::string& name) const;

  CommandLine& out_;
  std::unique_ptr<CLI::App> app_;  // behind a pointer: its header takes longer to compile than all of ours
};

/// "--queue-memory" for "Queue_Memory", and the other way round "queue_memory".
std::string option_of_setting(std::string_view setting);
std::string setting_of_option(std::string_view option);

}  // namespace firstlight::app
