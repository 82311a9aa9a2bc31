#pragma once

#include "parser/directive/reader.h"
#include "render/light/light.h"
#include "render/scene/photon_role.h"

namespace firstlight::parser {

/// `photons { ... }` of an object, whose word has been taken.
void parse_object_photons(Reader& reader, const Token& word, render::PhotonRole& role);

/// `photons { ... }` of a light, whose word has been taken.
void parse_light_photons(Reader& reader, const Token& word, render::Light& light);

}  // namespace firstlight::parser
