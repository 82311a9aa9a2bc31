#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "render/shape/blob.h"

namespace firstlight::parser {

using render::BlobParameters;
using render::Object;
using Component = BlobParameters::Component;
using Textures = std::vector<render::TexturePtr>;

namespace {

/// Transformations and the texture of a component, up to its `}`. A scratch object takes them as any object would.
void parse_component_end(Reader& reader, SceneContext& context, Textures& textures, Component& component) {
  Object scratch;
  for (;;) {
    if (const auto transform = accept_transformation(reader)) {
      render::place(scratch, *transform);
      continue;
    }
    const Token& next = reader.peek();
    const bool surface =
        next.is(Keyword::texture) || next.is(Keyword::pigment) || next.is(Keyword::normal) || next.is(Keyword::finish);
    if (!surface || !accept_surface_modifier(reader, context, scratch)) break;
  }
  reader.close_block();
  component.placement = scratch.placement;
  if (!scratch.texture) return;
  component.texture = static_cast<std::uint32_t>(textures.size());
  textures.push_back(moved(scratch.texture, scratch.texture_placement));
}

void parse_radius_and_strength(Reader& reader, Component& component) {
  component.radius = finite_number(reader, "radius in 'blob'");
  reader.skip_comma();
  reader.accept(Keyword::strength);
  component.strength = finite_number(reader, "strength in 'blob'");
}

/// `component strength, radius, center`, the old form of a sphere.
Component parse_plain(Reader& reader) {
  Component component;
  component.strength = finite_number(reader, "strength in 'blob'");
  reader.skip_comma();
  component.radius = finite_number(reader, "radius in 'blob'");
  reader.skip_comma();
  component.center = finite_vector(reader, "center in 'blob'");
  return component;
}

Component parse_sphere_component(Reader& reader, SceneContext& context, Textures& textures,
                                   const Token& word) {
  reader.open_block(word);
  Component component;
  component.center = finite_vector(reader, "center in 'blob'");
  reader.skip_comma();
  parse_radius_and_strength(reader, component);
  parse_component_end(reader, context, textures, component);
  return component;
}

Component parse_cylinder_component(Reader& reader, SceneContext& context, Textures& textures,
                                   const Token& word) {
  reader.open_block(word);
  Component component;
  component.kind = Component::Kind::cylinder;
  component.center = finite_vector(reader, "end in 'blob'");
  reader.skip_comma();
  component.end = finite_vector(reader, "end in 'blob'");
  reader.skip_comma();
  parse_radius_and_strength(reader, component);
  parse_component_end(reader, context, textures, component);
  return component;
}

}  // namespace

void parse_blob(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  BlobParameters blob;
  Textures textures;
  for (;;) {
    const Token& next = reader.peek();
    if (reader.accept(Keyword::threshold)) {
      blob.threshold = finite_number(reader, "threshold");
      continue;
    }
    if (reader.accept(Keyword::component)) {
      blob.components.push_back(parse_plain(reader));
    } else if (reader.accept(Keyword::sphere)) {
      blob.components.push_back(parse_sphere_component(reader, context, textures, next));
    } else if (reader.accept(Keyword::cylinder)) {
      const Component cylinder = parse_cylinder_component(reader, context, textures, next);
      if ((cylinder.end - cylinder.center).length() < kTinyLength) {
        reader.fail(next, "'cylinder' in 'blob' has no length: its two ends are the same point");
      }
      blob.components.push_back(cylinder);
    } else {
      break;
    }
    if (blob.components.size() > kMostPoints) {
      reader.fail(next, "'blob' has more than " + std::to_string(kMostPoints) + " parts");
    }
  }
  if (!textures.empty()) object.extras.change().shape_textures = std::move(textures);
  if (blob.components.empty()) reader.fail(word, "'blob' needs at least one 'sphere', 'cylinder' or 'component'");
  object.shape = render::make_blob(blob);
}

}  // namespace firstlight::parser
