#pragma once

#include "app/options.h"

#include <span>
#include <string>
#include <vector>

namespace firstlight::app {

/// The command line of `firstlight study`.
struct StudyOptions {
  Options scene;                     ///< the picture: scene, size, threads, queue memory ...
  std::string folder;                ///< the report's
  std::vector<std::string> schemes;  ///< texts of orders; empty: all that there are
  int rounds = 3;                    ///< in which times are taken
  bool every_feeler = false;         ///< is traced, also those whose end could be foreseen
};

struct StudyCommandLine {
  enum class Wish { study, help };

  Wish wish = Wish::study;
  StudyOptions options;
  std::vector<std::string> warnings;
  std::vector<std::string> errors;  ///< when not empty, nothing else counts
};

/// Reads the arguments behind the word `study`.
StudyCommandLine parse_study_command_line(std::span<const std::string> arguments);

std::string study_help_text();

/// The traditional order, an example of every scheme, and a mixture.
std::vector<std::string> all_study_schemes();

}  // namespace firstlight::app
