#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"

#include <string>
#include <utility>

namespace firstlight::parser {

using render::Interior;
using render::Transform;

namespace {

constexpr std::size_t kMostMedia = 1000;

bool accept_item(Reader& reader, SceneContext& context, Interior& interior) {
  if (reader.accept(Keyword::ior)) {
    interior.ior = finite_number(reader, "ior");
    interior.has_ior = interior.ior != 0.0;
    if (!interior.has_ior) interior.ior = 1.0;  // 0 stands for the air around
  } else if (reader.accept(Keyword::fade_distance)) {
    interior.fade_distance = finite_number(reader, "fade_distance");
  } else if (reader.accept(Keyword::fade_power)) {
    interior.fade_power = finite_number(reader, "fade_power");
  } else if (reader.accept(Keyword::fade_color)) {
    interior.fade_color = color_or_black(reader).rgb;
  } else if (reader.next_is(Keyword::refraction)) {
    const Token& word = reader.take();
    interior.refraction_scale = finite_number(reader, "refraction");
    reader.warn(word, "'refraction' is not needed to make light bend");
  } else if (reader.accept(Keyword::dispersion)) {
    const Token& at = reader.peek();
    interior.dispersion = finite_number(reader, "dispersion");
    if (interior.dispersion <= 0.0) reader.fail(at, "'dispersion' must be above 0");
  } else if (reader.accept(Keyword::dispersion_samples)) {
    const Token& at = reader.peek();
    interior.dispersion_samples = integer(reader, "dispersion_samples");
    if (interior.dispersion_samples < 2) reader.fail(at, "'dispersion_samples' must be at least 2");
    if (interior.dispersion_samples > Interior::kMostBands) {
      reader.fail(at, "'dispersion_samples' must be at most " + std::to_string(Interior::kMostBands));
    }
  } else if (reader.next_is(Keyword::caustics)) {
    const Token& word = reader.take();
    interior.caustics = finite_number(reader, "caustics");
    interior.unrendered.add(feature_use(render::Feature::caustics, word));
  } else if (reader.next_is(Keyword::media)) {
    const Token& word = reader.take();
    if (interior.media.size() >= kMostMedia) reader.fail(word, "an 'interior' has more than 1000 media");
    interior.media.push_back(parse_media(reader, context, word));
  } else {
    return false;
  }
  return true;
}

}  // namespace

Interior parse_interior(Reader& reader, SceneContext& context, const Token& word, Interior start) {
  reader.open_block(word);
  Interior interior = std::move(start);
  if (const auto declared = reader.accept_declared<Interior>()) interior = *declared;
  while (accept_item(reader, context, interior)) {
  }
  reader.close_block();
  return interior;
}

void parse_material(Reader& reader, SceneContext& context, const Token& word, Material& material) {
  reader.open_block(word);
  if (const auto declared = reader.accept_declared<Material>()) {
    material.texture = layered(reader, moved(declared->texture, declared->texture_placement), material.texture);
    material.interior_texture = layered(reader, declared->interior_texture, material.interior_texture);
    material.interior = declared->interior;
  }
  for (;;) {
    if (reader.next_is(Keyword::texture)) {
      const Token& inner = reader.take();
      material.texture = layered(reader, parse_texture(reader, context, inner), material.texture);
    } else if (reader.next_is(Keyword::interior_texture)) {
      const Token& inner = reader.take();
      material.interior_texture = layered(reader, parse_texture(reader, context, inner), material.interior_texture);
    } else if (reader.next_is(Keyword::interior)) {
      const Token& inner = reader.take();
      material.interior =
          parse_interior(reader, context, inner, material.interior.value_or(render::Shared<Interior>()));
    } else if (const auto transform = accept_transformation(reader)) {
      material.texture = moved(material.texture, *transform);
      if (material.interior) move(*material.interior, *transform);
    } else {
      break;
    }
  }
  reader.close_block();
}

}  // namespace firstlight::parser
