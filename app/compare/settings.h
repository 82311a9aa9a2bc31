#pragma once

#include "app/compare/record.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

/// A program's results for a scene, as many as rounds were asked for.
struct Rendered {
  std::vector<ProgramRun> runs;         ///< a run a round; empty when it failed
  std::filesystem::path picture;        ///< PNG; empty when it failed
  std::string error;                    ///< why it failed, in the program's own words; empty when it did not
  std::vector<MissingFeature> missing;  ///< only of Firstlight, and only when it failed for it
};

/// One scene to be rendered by both programs, in the folder in which it lies.
struct SceneJob {
  std::filesystem::path scene;
  std::optional<std::filesystem::path> ini;  ///< settings of its own, with a section in brackets if it has one
  std::string name;                          ///< SceneRecord::name
  /// A folder that is there, for povray.png and firstlight.png; empty: they are removed at the end.
  std::filesystem::path pictures;
  /// POV-Ray's part from before, when it need not be run again; its picture is read where it lies.
  const Rendered* povray = nullptr;
};

/// The least number of 100 pixels that must be within 2/255, when nothing else is asked for.
inline constexpr double kShare = 98.0;

/// From where on two pictures count as the same.
struct Thresholds {
  std::optional<double> share;  ///< of 100 pixels, those that must be within 2/255; kShare when no threshold is set
  std::optional<double> psnr;   ///< dB
  /// Pictures that miss a threshold, but whose means of 8x8 pixels are so near, warn: they differ in their grain only.
  double psnr_8x8 = 40.0;  // dB
};

/// How scenes are compared.
struct CompareSettings {
  int width = 0;  ///< pixels; 0: as the scene's .ini file says, else POV-Ray's 320 by 240
  int height = 0;
  int threads = 1;                       ///< of each program
  std::vector<std::string> words;        ///< switches that both programs are given besides, such as "+A0.3", "+R3"
  std::vector<std::string> our_words;    ///< options that only Firstlight is given, such as "--scheme=level"
  int rounds = 1;                        ///< the programs are run in turn, so often
  std::chrono::seconds time_limit{600};  ///< of one run of a program
  std::string povray = "povray";         ///< looked for in PATH when it is a name without a slash
  std::filesystem::path firstlight;      ///< empty: the program that runs
  Thresholds thresholds;
  const std::atomic<bool>* stop = nullptr;    ///< becomes true when the user wants an end
  std::function<void(std::string_view)> say;  ///< told what begins now; may be empty; called from any thread
};

}  // namespace firstlight::app::compare
