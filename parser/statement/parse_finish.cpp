#include "parser/statement/old_texture.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace firstlight::parser {

using render::Finish;
using render::Rgb;

namespace {

/// A block under way: strengths given as `albedo` are scaled when everything they depend on is known.
struct Draft {
  Finish finish;
  bool diffuse_albedo = false;
  bool phong_albedo = false;
  bool specular_albedo = false;
};

Rgb rgb(Reader& reader) { return color_or_black(reader).rgb; }

/// The power for the reflected colour; scenes give its reciprocal.
double parse_exponent(Reader& reader) {
  const Token& at = reader.peek();
  const double value = finite_number(reader, "exponent");
  if (value == 0.0) reader.fail(at, "the exponent of a reflection cannot be 0");
  return 1.0 / value;
}

/// `reflection` in its two forms: a colour, or `{ colour [, colour] options }`.
void parse_reflection(Reader& reader, const Token& word, Finish& finish) {
  if (reader.at_expression()) {
    finish.reflection_min = finish.reflection_max = rgb(reader);
    finish.reflection_falloff = 1.0;
    finish.reflection_fresnel = false;
    return;
  }
  if (!reader.next_is(Punctuation::left_brace)) {
    reader.warn(word, "'reflection' without a colour or a block does nothing");
    return;
  }
  reader.open_block(word);
  finish.reflection_min = rgb(reader);
  reader.skip_comma();
  const bool has_maximum = reader.at_expression();
  finish.reflection_max = has_maximum ? rgb(reader) : finish.reflection_min;
  for (;;) {
    if (reader.accept(Keyword::fresnel)) {
      const Token& at = reader.peek();
      const int flag = static_cast<int>(finite(reader, at, reader.optional_number(1.0), "fresnel"));
      if (flag < 0 || flag > 1) reader.fail(at, "'fresnel' must be on or off");
      finish.reflection_fresnel = flag == 1;
      // with one colour only, fresnel would have nothing to go between
      if (!has_maximum && finish.reflection_fresnel) finish.reflection_min = Rgb(0.0f);
    } else if (reader.accept(Keyword::falloff)) {
      finish.reflection_falloff = finite_number(reader, "falloff");
    } else if (reader.accept(Keyword::exponent)) {
      finish.reflection_exponent = parse_exponent(reader);
    } else if (reader.accept(Keyword::metallic)) {
      finish.reflection_metallic = reader.optional_number(1.0);
    } else {
      break;
    }
  }
  reader.close_block();
}

bool accept_highlight(Reader& reader, Draft& draft) {
  Finish& finish = draft.finish;
  if (reader.accept(Keyword::phong)) {
    while (reader.accept(Keyword::albedo)) draft.phong_albedo = true;
    finish.phong = finite_number(reader, "phong");
  } else if (reader.accept(Keyword::phong_size)) {
    finish.phong_size = finite_number(reader, "phong_size");
  } else if (reader.accept(Keyword::specular)) {
    while (reader.accept(Keyword::albedo)) draft.specular_albedo = true;
    finish.specular = finite_number(reader, "specular");
  } else if (reader.next_is(Keyword::roughness)) {
    const Token& word = reader.take();
    finish.roughness_exponent = finite_number(reader, "roughness");
    if (finish.roughness_exponent != 0.0) {
      finish.roughness_exponent = 1.0 / finish.roughness_exponent;
    } else {
      reader.warn(word, "'roughness' is 0");
    }
  } else if (reader.accept(Keyword::metallic)) {
    finish.metallic = reader.optional_number(1.0);
  } else {
    return false;
  }
  return true;
}

/// Words that old scenes have in the finish.
bool accept_legacy(Reader& reader, Finish& finish) {
  if (reader.next_is(Keyword::ior)) {
    const Token& word = reader.take();
    finish.legacy_ior = finite_number(reader, "ior");
    reader.warn(word, "'ior' belongs in 'interior'");
  } else if (reader.next_is(Keyword::refraction)) {
    const Token& word = reader.take();
    finish.legacy_refraction = finite_number(reader, "refraction");
    reader.warn(word, "'refraction' belongs in 'interior', and is not needed to make light bend");
  } else if (reader.next_is(Keyword::caustics)) {
    const Token& word = reader.take();
    finish.legacy_caustics = finite_number(reader, "caustics");
    finish.unrendered.add(feature_use(render::Feature::caustics, word));
    reader.warn(word, "'caustics' belongs in 'interior'");
  } else {
    return false;
  }
  return true;
}

/// `irid { amount [thickness n] [turbulence n] }`
void parse_irid(Reader& reader, const Token& word, Finish& finish) {
  reader.open_block(word);
  finish.irid = finite_number(reader, "irid");
  for (;;) {
    if (reader.accept(Keyword::thickness)) {
      finish.irid_thickness = finite_number(reader, "thickness");
    } else if (reader.accept(Keyword::turbulence)) {
      finish.irid_turbulence = finite_vector(reader, "turbulence").x;  // only the first component counts
    } else {
      break;
    }
  }
  reader.close_block();
}

/// `subsurface { [translucency colour] [anisotropy colour] }`
void parse_subsurface(Reader& reader, const Token& word, Finish& finish) {
  finish.subsurface = true;
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::translucency)) {
      finish.subsurface_translucency = rgb(reader);
    } else if (reader.accept(Keyword::anisotropy)) {
      finish.subsurface_anisotropy = rgb(reader);
    } else {
      break;
    }
  }
  reader.close_block();
}

bool accept_effect(Reader& reader, Finish& finish) {
  const Token& word = reader.peek();
  if (reader.accept(Keyword::crand)) {
    finish.crand = finite_number(reader, "crand");
    finish.unrendered.add(feature_use(render::Feature::crand, word));
  } else if (reader.accept(Keyword::irid)) {
    parse_irid(reader, word, finish);
    finish.unrendered.add(feature_use(render::Feature::irid, word));
  } else if (reader.accept(Keyword::subsurface)) {
    parse_subsurface(reader, word, finish);
    finish.unrendered.add(feature_use(render::Feature::subsurface, word));
  } else {
    return false;
  }
  return true;
}

bool accept_item(Reader& reader, Draft& draft) {
  Finish& finish = draft.finish;
  if (reader.accept(Keyword::ambient)) {
    finish.ambient = rgb(reader);
  } else if (reader.accept(Keyword::emission)) {
    finish.emission = rgb(reader);
  } else if (reader.accept(Keyword::diffuse)) {
    while (reader.accept(Keyword::albedo)) draft.diffuse_albedo = true;
    finish.diffuse = finite_number(reader, "diffuse");
    reader.skip_comma();
    finish.diffuse_back = reader.optional_number(0.0);
  } else if (reader.accept(Keyword::brilliance)) {
    finish.brilliance = finite_number(reader, "brilliance");
  } else if (reader.accept(Keyword::conserve_energy)) {
    finish.conserve_energy = true;
  } else if (reader.next_is(Keyword::reflection)) {
    const Token& word = reader.take();
    parse_reflection(reader, word, finish);
  } else if (reader.accept(Keyword::reflection_exponent)) {
    finish.reflection_exponent = parse_exponent(reader);
  } else {
    return accept_highlight(reader, draft) || accept_effect(reader, finish) || accept_legacy(reader, finish);
  }
  return true;
}

/// Whether nothing tells the two apart. A finish with a word that cannot be rendered is told by its place.
bool are_same(const Finish& a, const Finish& b) {
  const auto numbers_of = [](const Finish& finish) {
    const auto& [ambient, emission, diffuse, diffuse_back, brilliance, phong, phong_size, specular, roughness_exponent,
                 metallic, reflection_min, reflection_max, reflection_falloff, reflection_metallic, reflection_exponent,
                 reflection_fresnel, conserve_energy, crand, irid, irid_thickness, irid_turbulence, subsurface,
                 subsurface_translucency, subsurface_anisotropy, unrendered, legacy_ior, legacy_refraction,
                 legacy_caustics] = finish;
    return std::tie(ambient, emission, diffuse, diffuse_back, brilliance, phong, phong_size, specular,
                    roughness_exponent, metallic, reflection_min, reflection_max, reflection_falloff,
                    reflection_metallic, reflection_exponent, reflection_fresnel, conserve_energy, crand, irid,
                    irid_thickness, irid_turbulence, subsurface, subsurface_translucency, subsurface_anisotropy,
                    legacy_ior, legacy_refraction, legacy_caustics);
  };
  return a.unrendered.empty() && b.unrendered.empty() && numbers_of(a) == numbers_of(b);
}

/// Strengths given as `albedo` mean the share of the light that comes back in all; what the formulas of shading
/// want is the strength straight back. The factors are POV-Ray 3.7's.
void apply_albedo(Draft& draft) {
  Finish& finish = draft.finish;
  if (draft.diffuse_albedo) {
    const double factor = (finish.brilliance + 1.0) / 2.0;
    finish.diffuse *= factor;
    finish.diffuse_back *= factor;
  }
  if (draft.phong_albedo) finish.phong *= (finish.phong_size + 1.0) / 2.0;
  if (draft.specular_albedo) {
    const double n = finish.roughness_exponent;
    finish.specular *= (n + 2.0) / (4.0 * (2.0 - std::pow(2.0, -n / 2.0)));
  }
}

}  // namespace

bool accept_bare_finish(Reader& reader, Finish& finish) {
  Draft draft{finish};
  if (!accept_item(reader, draft)) return false;
  finish = draft.finish;
  return true;
}

render::Shared<Finish> kept_once(SceneContext& context, Finish finish) {
  if (!are_same(*context.last_finish, finish)) context.last_finish = std::move(finish);
  return context.last_finish;
}

Finish parse_finish(Reader& reader, const Token& word, Finish start) {
  reader.open_block(word);
  Draft draft{start};
  if (const auto declared = reader.accept_declared<Finish>()) draft.finish = *declared;
  while (accept_item(reader, draft)) {
  }
  apply_albedo(draft);
  reader.close_block();
  return draft.finish;
}

}  // namespace firstlight::parser
