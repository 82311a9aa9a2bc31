#include "parser/statement/blend_map.h"

namespace firstlight::parser {

namespace {

template <class T>
void deepen(render::BlendMap<T>& map, std::uint32_t below) {
  map.depth = std::max(map.depth, below);
}

}  // namespace

void nest(Reader& reader, const Token& word, std::uint32_t& depth, std::uint32_t below) {
  depth = std::max(depth, below + 1);
  if (depth > kMaxDescriptionDepth) {
    reader.fail(word,
                "descriptions are nested more than " + std::to_string(kMaxDescriptionDepth) + " deep, one in another");
  }
}

void absorb(render::PigmentMap& map, const render::Pigment& pigment) {
  deepen(map, pigment.pattern->depth);
  map.translucent = map.translucent || lets_light_through(pigment);
  gather(pigment, map.unrendered);
}

void absorb(render::NormalMap& map, const render::Normal& normal) {
  deepen(map, normal.pattern.depth);
  gather(normal, map.unrendered);
}

void absorb(render::SlopeMap&, const render::SlopePoint&) {}

void absorb(render::TextureMap& map, const render::TexturePtr& texture) {
  deepen(map, depth_of(*texture));
  map.translucent = map.translucent || !is_opaque(*texture);
  gather(*texture, map.unrendered);
}

void absorb(render::DensityMap& map, const render::Density& density) {
  deepen(map, density.pattern.depth);
  gather(density, map.unrendered);
}

}  // namespace firstlight::parser
