#include "parser/statement/parse_atmosphere.h"

#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::Feature;
using render::Fog;
using render::Rainbow;
using render::SkySphere;
using render::Vec3;

namespace {

constexpr std::size_t kMostPigments = 1000;  // of a sky sphere

render::FogTurbulence& turbulence_of(Fog& fog) {
  if (!fog.turbulence) fog.turbulence.emplace();
  return *fog.turbulence;
}

bool accept_fog_turbulence(Reader& reader, Fog& fog) {
  if (reader.accept(Keyword::turbulence)) {
    turbulence_of(fog).amount = finite_vector(reader, "turbulence");
  } else if (reader.accept(Keyword::octaves)) {
    turbulence_of(fog).octaves = integer(reader, "octaves", 1, 10);
  } else if (reader.accept(Keyword::omega)) {
    turbulence_of(fog).omega = finite_number(reader, "omega");
  } else if (reader.accept(Keyword::lambda)) {
    turbulence_of(fog).lambda = finite_number(reader, "lambda");
  } else if (reader.accept(Keyword::turb_depth)) {
    fog.turbulence_depth = finite_number(reader, "turb_depth");
  } else {
    return false;
  }
  return true;
}

bool accept_fog_item(Reader& reader, Fog& fog) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::distance)) {
    fog.distance = finite_number(reader, "distance");
  } else if (reader.accept(Keyword::fog_type)) {
    fog.type = integer(reader, "fog_type");
    if (fog.type < Fog::kConstant || fog.type > Fog::kGround) {
      reader.warn(word, "'fog_type' must be 1 or 2; any other is taken for 1");
    }
  } else if (reader.accept(Keyword::fog_alt)) {
    fog.altitude = finite_number(reader, "fog_alt");
  } else if (reader.accept(Keyword::fog_offset)) {
    fog.offset = finite_number(reader, "fog_offset");
  } else if (reader.accept(Keyword::up)) {
    fog.up = finite_vector(reader, "up");
  } else if (at_color(reader)) {
    fog.color = reader.color();
  } else if (reader.at_number()) {
    if (language_version(reader) >= 150) reader.warn(word, "the distance of 'fog' should have the word 'distance'");
    fog.distance = finite_number(reader, "distance");
  } else if (const auto transform = accept_transformation(reader)) {
    if (word.is(Keyword::translate)) reader.warn(word, "'translate' does nothing to a fog");
    fog.up = transform->direction(fog.up);
  } else {
    return accept_fog_turbulence(reader, fog);
  }
  return true;
}

/// Half of an angle from 0 to 360 degrees, in radians.
double parse_half_angle(Reader& reader, const Token& word) {
  const Token& at = reader.peek();
  const double angle = finite_number(reader, word.text);
  if (angle < 0.0 || angle > 360.0) reader.fail(at, quoted(word) + " must be from 0 to 360 degrees");
  return angle * (std::numbers::pi / 360.0);
}

struct RainbowDraft {
  Rainbow rainbow;
  bool arc_given = false, falloff_given = false;
};

bool accept_rainbow_item(Reader& reader, RainbowDraft& draft) {
  Rainbow& rainbow = draft.rainbow;
  const Token& word = reader.peek();
  if (reader.accept(Keyword::angle)) {
    rainbow.angle = finite_number(reader, "angle");
  } else if (reader.accept(Keyword::direction)) {
    rainbow.direction = finite_vector(reader, "direction");
  } else if (reader.accept(Keyword::color_map)) {
    rainbow.colors = parse_color_map(reader, word);
  } else if (reader.accept(Keyword::distance)) {
    rainbow.distance = finite_number(reader, "distance");
  } else if (reader.accept(Keyword::jitter)) {
    rainbow.jitter = finite_number(reader, "jitter");
  } else if (reader.accept(Keyword::width)) {
    rainbow.width = finite_number(reader, "width");
  } else if (reader.accept(Keyword::up)) {
    rainbow.up = finite_vector(reader, "up");
  } else if (reader.accept(Keyword::arc_angle)) {
    rainbow.arc_half_angle = parse_half_angle(reader, word);
    draft.arc_given = true;
  } else if (reader.accept(Keyword::falloff_angle)) {
    rainbow.falloff_half_angle = parse_half_angle(reader, word);
    draft.falloff_given = true;
  } else {
    return false;
  }
  return true;
}

/// Makes the two axes of the bow what they must be.
void orient(Reader& reader, const Token& word, Rainbow& rainbow) {
  if (rainbow.direction.length2() < kTinyLength) reader.fail(word, "the 'direction' of 'rainbow' is zero");
  if (rainbow.up.length2() < kTinyLength) reader.fail(word, "the 'up' of 'rainbow' is zero");
  rainbow.direction.normalize();
  rainbow.up.normalize();
  if (std::abs(1.0 - std::abs(rainbow.up.dot(rainbow.direction))) < kTinyLength) {
    reader.fail(word, "'up' and 'direction' of 'rainbow' must not be parallel");
  }
  rainbow.up = rainbow.direction.cross(rainbow.up.cross(rainbow.direction)).normalized();
}

void add_sky_sphere(Reader& reader, SceneContext& context, const Token& word) {
  std::shared_ptr<const SkySphere>& sky = context.builder.atmosphere().sky_sphere;
  if (sky) reader.warn(word, "more than one 'sky_sphere' in the scene; the last one counts");
  sky = std::make_shared<const SkySphere>(parse_sky_sphere(reader, context, word));
}

}  // namespace

Fog parse_fog(Reader& reader, const Token& word) {
  reader.open_block(word);
  Fog fog;
  if (const auto declared = reader.accept_declared<Fog>()) fog = *declared;
  while (accept_fog_item(reader, fog)) {
  }
  reader.close_block();
  if (fog.up.length() > 0.0) fog.up.normalize();
  fog.unrendered = {};
  if (std::abs(fog.distance) > kTinyLength) fog.unrendered.add(feature_use(Feature::fog, word));
  return fog;
}

Rainbow parse_rainbow(Reader& reader, const Token& word) {
  reader.open_block(word);
  RainbowDraft draft;
  Rainbow& rainbow = draft.rainbow;
  if (const auto declared = reader.accept_declared<Rainbow>()) {
    rainbow = *declared;
    // POV-Ray 3.7 turns the angles of the middle and of the width into those of the inner border and of the width in
    // radians at the end of every block, and so twice for a rainbow that was declared.
    constexpr double kRadian = std::numbers::pi / 180.0;
    rainbow.angle = (rainbow.angle - 0.5 * rainbow.width) * kRadian;
    rainbow.width *= kRadian;
  }
  while (accept_rainbow_item(reader, draft)) {
  }
  reader.close_block();
  if (draft.arc_given && !draft.falloff_given) rainbow.falloff_half_angle = rainbow.arc_half_angle;
  if (rainbow.arc_half_angle < rainbow.falloff_half_angle) {
    reader.fail(word, "the 'arc_angle' of 'rainbow' must not be smaller than its 'falloff_angle'");
  }
  orient(reader, word, rainbow);
  rainbow.unrendered = {};
  if (rainbow.shows()) rainbow.unrendered.add(feature_use(Feature::rainbow, word));
  return std::move(rainbow);
}

SkySphere parse_sky_sphere(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  SkySphere sky;
  if (const auto declared = reader.accept_declared<SkySphere>()) sky = *declared;
  for (;;) {
    const Token& item = reader.peek();
    if (reader.accept(Keyword::pigment)) {
      sky.pigments.push_back(parse_pigment(reader, context, item, render::Pigment()));
      if (sky.pigments.size() > kMostPigments) reader.fail(item, "a 'sky_sphere' has at most 1000 pigments");
    } else if (reader.accept(Keyword::emission)) {
      sky.emission = reader.color().rgb;
    } else if (const auto transform = accept_transformation(reader)) {
      sky.placement = sky.placement.then(*transform);
    } else {
      break;
    }
  }
  reader.close_block();
  if (sky.pigments.empty()) reader.fail(word, "a 'sky_sphere' needs at least one 'pigment'");
  sky.unrendered = {};
  sky.unrendered.add(feature_use(Feature::sky_sphere, word));
  return sky;
}

void parse_background(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  render::FilteredColor color = color_or_black(reader);
  reader.close_block();
  // before 3.7 a background was always clear where the picture has an alpha channel
  const bool old_rules = effective_language_version(reader) < 370;
  const float transmit = old_rules ? 0.0f : color.transmit;
  if (old_rules) color = {color.rgb, 0.0f, 1.0f};
  context.builder.settings().background = color.rgb * (1.0f - transmit);
  context.builder.settings().background_with_alpha = color;
}

bool accept_atmosphere(Reader& reader, SceneContext& context) {
  const Token& word = reader.peek();
  switch (word.keyword) {
    case Keyword::background:
      reader.take();
      parse_background(reader, context, word);
      return true;
    case Keyword::fog:
      reader.take();
      context.builder.atmosphere().fogs.push_back(parse_fog(reader, word));
      return true;
    case Keyword::rainbow:
      reader.take();
      context.builder.atmosphere().rainbows.push_back(parse_rainbow(reader, word));
      return true;
    case Keyword::media:
      reader.take();
      context.builder.atmosphere().media.push_back(parse_media(reader, context, word));
      return true;
    case Keyword::sky_sphere:
      reader.take();
      add_sky_sphere(reader, context, word);
      return true;
    default:
      return false;
  }
}

}  // namespace firstlight::parser
