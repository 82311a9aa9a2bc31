#pragma once

#include "app/compare/options.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// The command line of `firstlight compare` for many scenes.
struct ListCommandLine {
  CompareCommandLine common;        ///< its errors are of both
  bool is_asked_for = false;        ///< a list, a folder, several scenes, or something that only this gives
  std::filesystem::path list;       ///< file; empty: the subjects are folders and scenes
  std::filesystem::path root;       ///< of the list's names; empty: the list's folder
  std::filesystem::path cache;      ///< empty: the user's
  std::filesystem::path report;     ///< folder; empty: none, as with the next two
  std::filesystem::path agreement;  ///< Markdown file
  std::filesystem::path json;       ///< file; common.json: to the standard output
  int jobs = 1;
  bool again = false;
  bool povray_too = false;
};

/// Reads the arguments behind the word `compare`.
ListCommandLine parse_list_command_line(std::span<const std::string> arguments);

}  // namespace firstlight::app::compare
