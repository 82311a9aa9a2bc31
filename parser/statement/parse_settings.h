#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"

namespace firstlight::parser {

/// The block after `global_settings`, whose word has been taken.
void parse_global_settings(Reader& reader, SceneContext& context, const Token& word);
/// The blocks after `radiosity` and `photons` in it, whose words have been taken.
void parse_radiosity(Reader& reader, SceneContext& context, const Token& word);
/// At the end of a scene with radiosity: whether what it says agrees.
void check_radiosity(Reader& reader, SceneContext& context);
void parse_photon_settings(Reader& reader, SceneContext& context, const Token& word);
/// The number after `max_trace_level`, wherever that stands.
void parse_max_trace_level(Reader& reader, SceneContext& context, const Token& word);
/// The number after `max_intersections`, which has no meaning any more.
void parse_max_intersections(Reader& reader, const Token& word);

}  // namespace firstlight::parser
