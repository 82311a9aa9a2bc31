#pragma once

#include "app/compare/record.h"

#include <nlohmann/json.hpp>

#include <span>

namespace firstlight::app::compare {

/// `{"totals": {...}, "scenes": [what one scene's JSON has]}`
nlohmann::ordered_json sweep_json(std::span<const SceneRecord> records);

}  // namespace firstlight::app::compare
