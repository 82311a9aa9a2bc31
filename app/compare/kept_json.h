#pragma once

#include "app/compare/record.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace firstlight::app::compare {

// Reads what record_json.h makes.

/// Nothing when it is not what a record becomes.
std::optional<SceneRecord> record_of(const nlohmann::ordered_json& json);
/// Throws nlohmann::json::exception when it is not what a run becomes.
ProgramRun run_of(const nlohmann::ordered_json& json);

}  // namespace firstlight::app::compare
