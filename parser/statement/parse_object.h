#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/scene/object.h"

#include <optional>
#include <vector>

namespace firstlight::parser {

/// Objects in a scene, counting shared ones as often as they occur; more would not fit into a machine's memory.
constexpr std::uint64_t kMaxObjects = 4'000'000;

/// A declared object, if the next token names one.
std::optional<render::Object> accept_declared_object(Reader& reader);

/// Parses what may follow the geometry of any object, and the `}` that closes it. `word` began the object.
void parse_modifiers(Reader& reader, SceneContext& context, const Token& word, render::Object& object);

/// `radiosity { importance n }`; nothing when the block is empty. The word has been taken.
std::optional<double> parse_importance(Reader& reader, const Token& word);

/// `bounded_by` and `clipped_by`. The word has been taken.
void parse_bounded_by(Reader& reader, SceneContext& context, const Token& word, render::Object& object);
void parse_clipped_by(Reader& reader, SceneContext& context, const Token& word, render::Object& object);

/// `union`, `merge`, `intersection`, `difference`. The word has been taken.
render::Object parse_csg(Reader& reader, SceneContext& context, const Token& word);

/// The word `light_group` has been taken.
render::Object parse_light_group(Reader& reader, SceneContext& context, const Token& word);

/// The word `light_source` has been taken.
render::Object parse_light(Reader& reader, SceneContext& context, const Token& word);

/// Enters `part` into the size of `whole`; fails at `at` when the whole grows out of all proportion.
void count_in(Reader& reader, const Token& at, render::Object& whole, const render::Object& part);

/// An object in which there is nothing.
render::Object empty_object();

}  // namespace firstlight::parser
