#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/parse_common.h"
#include "render/texture/media.h"
#include "render/texture/texture.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace firstlight::parser {

/// Levels of descriptions in descriptions; few enough to walk, and to free, by recursion.
constexpr std::uint32_t kMaxDescriptionDepth = 400;

/// Puts a description of depth `below` into one of depth `depth`; fails at `word` when they nest too deeply.
void nest(Reader& reader, const Token& word, std::uint32_t& depth, std::uint32_t below);

// Take from an entry what its map must know.
void absorb(render::PigmentMap& map, const render::Pigment& pigment);
void absorb(render::NormalMap& map, const render::Normal& normal);
void absorb(render::SlopeMap& map, const render::SlopePoint& point);
void absorb(render::TextureMap& map, const render::TexturePtr& texture);
void absorb(render::DensityMap& map, const render::Density& density);

template <class T>
void append(render::BlendMap<T>& map, double position, T value) {
  absorb(map, value);
  map.entries.push_back({position, std::move(value)});
}

/// `{ [position entry] ... }` or `{ declared one }`. `average`: the positions are weights and may be left out.
/// `read` reads an entry's contents. `feature` is what the map asks for, if anything.
template <class T, class Read>
std::shared_ptr<const render::BlendMap<T>> parse_blend_map(Reader& reader, const Token& word,
                                                           std::optional<render::Feature> feature, bool average,
                                                           Read read) {
  constexpr std::size_t kMostEntries = 256;  // POV-Ray's own limit
  reader.open_block(word);
  if (auto declared = reader.accept_declared<render::BlendMap<T>>()) {
    reader.close_block();
    return declared;
  }
  auto map = std::make_shared<render::BlendMap<T>>();
  if (feature) map->unrendered.add(feature_use(*feature, word));
  while (reader.next_is(Punctuation::left_bracket)) {
    const Token at = reader.take();
    if (map->entries.size() >= kMostEntries) reader.fail(at, "a " + quoted(word) + " has at most 256 entries");
    double position = 1.0;
    if (!average || reader.at_number()) position = finite_number(reader, "position in " + quoted(word));
    reader.skip_comma();
    append(*map, position, T(read()));
    if (!reader.accept(Punctuation::right_bracket)) reader.fail_expected("']'");
  }
  if (map->entries.empty()) reader.fail_expected("'[' and an entry of the map");
  reader.close_block();
  return map;
}

/// Up to `count` blocks that begin with `word`, the entries of a list pattern; the rest are `missing`. Null if there
/// are none and `optional`.
template <class T, class Read>
std::shared_ptr<render::BlendMap<T>> parse_block_list(Reader& reader, Keyword word, std::size_t count, const T& missing,
                                                      bool optional, Read read) {
  auto map = std::make_shared<render::BlendMap<T>>();
  while (map->entries.size() < count && reader.next_is(word)) {
    const Token block = reader.take();
    append(*map, static_cast<double>(map->entries.size()), T(read(block)));
    reader.skip_comma();
  }
  if (map->entries.empty() && optional) return nullptr;
  while (map->entries.size() < count) append(*map, static_cast<double>(map->entries.size()), T(missing));
  return map;
}

/// A map of one entry: what uv_mapping covers with.
template <class T>
std::shared_ptr<render::BlendMap<T>> single_entry(T value) {
  auto map = std::make_shared<render::BlendMap<T>>();
  append(*map, 0.0, std::move(value));
  return map;
}

}  // namespace firstlight::parser
