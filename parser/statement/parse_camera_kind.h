#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/camera/camera.h"

#include <optional>

namespace firstlight::parser {

/// If the next word names a kind of camera: takes it, with what belongs to it.
std::optional<render::CameraKind> accept_camera_kind(Reader& reader, SceneContext& context, render::MeshCamera& mesh);
bool names_camera_kind(const Token& word);

}  // namespace firstlight::parser
