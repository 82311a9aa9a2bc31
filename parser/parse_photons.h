#pragma once

#include "parser/reader.h"
#include "render/scene/photon_role.h"

namespace firstlight::parser {

/// `photons { ... }` of an object, whose word has been taken.
void parse_object_photons(Reader& reader, const Token& word, render::PhotonRole& role);

}  // namespace firstlight::parser
