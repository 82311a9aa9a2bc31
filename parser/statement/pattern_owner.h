#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/texture/patterning.h"

#include <cstddef>

namespace firstlight::parser {

/// Places that a pattern stands in.
enum class PatternPlace { pigment, normal, texture, density };

/// A block under way that is made of a pattern and a map: what parse_pattern() asks of pigments, normals, textures and
/// densities, which differ in their maps and lists.
class PatternOwner {
 public:
  explicit PatternOwner(PatternPlace place) : place_(place) {}
  PatternOwner(const PatternOwner&) = delete;
  PatternOwner& operator=(const PatternOwner&) = delete;

  PatternPlace place() const { return place_; }
  virtual const render::Patterning& pattern() const = 0;
  /// The pattern, to be changed.
  virtual render::Patterning& change_pattern() = 0;

  /// A colour as the first item, which is all the pattern then.
  virtual void parse_color(Reader& reader) = 0;
  /// Up to `count` entries of a list pattern; what is not given has its default.
  virtual void parse_list(Reader& reader, SceneContext& context, std::size_t count) = 0;
  /// Parses what stands behind `uv_mapping`: the contents of one more block of this kind.
  virtual void parse_item(Reader& reader, SceneContext& context) = 0;
  /// The block behind image_map or bump_map.
  virtual void parse_image(Reader&, SceneContext&, const Token&) {}
  /// Parses what may stand between the pattern and its modifiers.
  virtual void parse_amount(Reader&) {}
  /// Takes a map or another word of this kind alone. False: the next token is none.
  virtual bool accept_word(Reader& reader, SceneContext& context) = 0;
  virtual bool has_map() const = 0;

 protected:
  ~PatternOwner() = default;

 private:
  PatternPlace place_;
};

/// The inside of a block: a pattern or colour, and what may follow. [parse_pattern.cpp]
void parse_pattern(Reader& reader, SceneContext& context, PatternOwner& owner);
/// The pattern `word`, which has been taken, with its parameters and list. [parse_pattern_type.cpp]
void parse_pattern_type(Reader& reader, SceneContext& context, PatternOwner& owner, const Token& word,
                        render::PatternKind kind);
/// The pattern that a word names; none for other words, and for those that make no pattern in this place.
render::PatternKind pattern_kind(Reader& reader, PatternPlace place, const Token& word);
/// If the next word sets a parameter of the pattern at hand: takes it with its value. [parse_pattern_parameters.cpp]
bool accept_pattern_parameter(Reader& reader, render::Patterning& pattern);
/// Fails when the parameters do not go together.
void check_pattern_parameters(Reader& reader, const Token& word, const render::Patterning& pattern);

/// Whether a map goes with the pattern; fails if not. `word`: the map's.
void check_map_allowed(Reader& reader, const Token& word, const render::Patterning& pattern, bool average_allowed);

}  // namespace firstlight::parser
