#pragma once

#include "app/compare/record.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace firstlight::app::compare {

/// "agrees", "lacks_features" ...: the enumerator's own name, which stays when the wording of messages changes.
std::string_view status_name(Status status);

/// `{"name", "scene", "status", "message", "povray_message", "difference": {...} or null, "povray": [runs],
/// "firstlight": [runs], "missing": [...], "povray_picture", "our_picture"}`
nlohmann::ordered_json to_json(const SceneRecord& record);
nlohmann::ordered_json to_json(const ProgramRun& run);
/// An infinite PSNR is null.
nlohmann::ordered_json to_json(const PictureDifference& difference);

/// As a file; bytes that are not UTF-8 are replaced, so that a strange path costs no more than itself.
std::string text_of(const nlohmann::ordered_json& json);

}  // namespace firstlight::app::compare
