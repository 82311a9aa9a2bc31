#pragma once

#include "app/compare/process.h"
#include "app/compare/record.h"
#include "app/compare/settings.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

/// One run of a program on a scene.
struct SceneRun {
  ProcessResult process;
  ProgramRun times;
  std::string
      error;  ///< why there is no picture, in the program's own words as far as it had any; empty if there is one
};

/// Both write `picture`, a PNG file, and run in a Workplace of their own. They are given the same switches.
SceneRun run_povray(const SceneJob& job, const CompareSettings& settings, const std::filesystem::path& picture);
/// Its statistics are written beside the picture.
SceneRun run_firstlight(const SceneJob& job, const CompareSettings& settings, const std::filesystem::path& picture);

/// The features that the scene asks for and Firstlight cannot render; empty also when it cannot be read at all.
std::vector<MissingFeature> missing_features(const SceneJob& job, const CompareSettings& settings);

/// POV-Ray's own measure in what it printed, in seconds: `Trace Time: 0 hours 0 minutes 13 seconds (13.633 seconds)`,
/// where `label` is "Trace Time:". 0 when it took none, or said nothing of it.
double povray_seconds(std::string_view label, std::string_view printed);
/// The message by which POV-Ray says why it made no picture, in one line.
std::string povray_error(std::string_view printed);
/// The first error in what Firstlight printed.
std::string firstlight_error(std::string_view printed);

}  // namespace firstlight::app::compare
