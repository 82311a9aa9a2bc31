#pragma once

#include "app/compare/list.h"
#include "app/compare/record.h"
#include "app/compare/settings.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// Many scenes to be compared.
struct SweepPlan {
  using Compare = std::function<SceneRecord(const SceneJob&, const CompareSettings&)>;
  using Missing = std::function<std::vector<MissingFeature>(const SceneJob&, const CompareSettings&)>;
  using Begins = std::function<void(const std::string& name)>;
  using Ends = std::function<void(const SceneRecord& record, bool kept)>;  ///< `kept`: it was done before

  std::vector<ListedScene> scenes;
  CompareSettings settings;
  bool own_thresholds = true;   ///< scenes may say how near is near enough
  int jobs = 1;                 ///< scenes at a time
  std::filesystem::path cache;  ///< where results are kept
  bool again = false;           ///< what was kept of Firstlight is not used; POV-Ray's part is
  bool povray_too = false;      ///< POV-Ray renders also what Firstlight cannot for lack of features

  Compare compare;  ///< compare_scene
  Missing missing;  ///< missing_features
  Begins begins;    ///< may be empty, as may `ends`; called by one thread at a time
  Ends ends;
};

struct SweepResult {
  std::vector<SceneRecord> records;  ///< of the scenes that are done, in the order of the plan
  std::size_t kept = 0;              ///< how many of them were done before
  bool stopped = false;
  std::string error;  ///< why it ended too soon: what is done cannot be kept
};

/// Goes through the scenes and keeps each result when it is there, by what the scene is made of, by the options and
/// by both programs: a sweep that was stopped goes on where it was. It ends soon when the settings' `stop` becomes true.
SweepResult sweep(const SweepPlan& plan);

}  // namespace firstlight::app::compare
