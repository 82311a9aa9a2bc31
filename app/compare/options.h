#pragma once

#include "app/compare/settings.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// The command line of `firstlight compare`.
struct CompareCommandLine {
  enum class Wish { compare, help };

  Wish wish = Wish::compare;
  CompareSettings settings;
  std::vector<std::string> subjects;         ///< a scene or two pictures, as given
  std::optional<std::filesystem::path> ini;  ///< as SceneJob::ini, absolute
  std::filesystem::path keep;                ///< folder for the pictures, absolute; empty: they are not kept
  bool json = false;
  bool quiet = false;
  std::vector<std::string> errors;  ///< when not empty, nothing else counts
};

/// Reads the arguments behind the word `compare`.
CompareCommandLine parse_compare_command_line(std::span<const std::string> arguments);

std::string compare_help_text();

}  // namespace firstlight::app::compare
