#include "parser/statement/parse_warp.h"

#include "parser/statement/parse_common.h"
#include "render/math/single.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace firstlight::parser {

using render::BlackHoleWarp;
using render::Feature;
using render::in_single;
using render::RepeatWarp;
using render::Turbulence;
using render::Vec3;
using render::Warps;

namespace {

bool accept_detail(Reader& reader, Turbulence& turbulence) {
  if (reader.accept(Keyword::octaves)) {
    turbulence.octaves = integer(reader, "octaves", 1, 10);
  } else if (reader.accept(Keyword::omega)) {
    turbulence.omega = in_single(finite_number(reader, "omega"));
  } else if (reader.accept(Keyword::lambda)) {
    turbulence.lambda = in_single(finite_number(reader, "lambda"));
  } else {
    return false;
  }
  return true;
}

Vec3 direction(Reader& reader) {
  const Vec3 value = finite_vector(reader, "orientation");
  const double length = value.length();
  return length > 0.0 ? value / length : value;
}

/// `orientation` and `dist_exp`, which several warps have.
template <class T>
bool accept_direction(Reader& reader, T& warp) {
  if (reader.accept(Keyword::orientation)) {
    warp.orientation = direction(reader);
  } else if (reader.accept(Keyword::dist_exp)) {
    warp.distance_exponent = finite_number(reader, "dist_exp");
  } else {
    return false;
  }
  return true;
}

template <class T>
T parse_direction(Reader& reader) {
  T warp;
  while (accept_direction(reader, warp)) {
  }
  return warp;
}

render::ToroidalWarp parse_toroidal(Reader& reader) {
  render::ToroidalWarp warp;
  for (;;) {
    if (reader.accept(Keyword::major_radius)) {
      warp.major_radius = finite_number(reader, "major_radius");
    } else if (!accept_direction(reader, warp)) {
      return warp;
    }
  }
}

render::PlanarWarp parse_planar(Reader& reader) {
  render::PlanarWarp warp;
  if (!reader.at_expression()) return warp;
  warp.orientation = direction(reader);
  reader.skip_comma();
  warp.offset = finite_number(reader, "offset of 'planar'");
  return warp;
}

RepeatWarp parse_repeat(Reader& reader) {
  const Token& at = reader.peek();
  const Vec3 width = finite_vector(reader, "repeat");
  const auto is_axis = [&](int axis) { return width[axis] != 0.0; };
  if (is_axis(0) + is_axis(1) + is_axis(2) != 1) reader.fail(at, "'repeat' goes along one axis, x, y or z");
  RepeatWarp warp;
  warp.axis = is_axis(0) ? 0 : is_axis(1) ? 1 : 2;
  warp.width = in_single(width[warp.axis]);
  for (;;) {
    if (reader.accept(Keyword::offset)) {
      warp.offset = finite_vector(reader, "offset");
    } else if (reader.accept(Keyword::flip)) {
      const Vec3 flip = finite_vector(reader, "flip");
      for (int axis = 0; axis < 3; ++axis) warp.flip[axis] = flip[axis] != 0.0 ? -1.0 : 1.0;
    } else {
      return warp;
    }
  }
}

/// A repeated black hole must keep to its block: it is moved into it, and a block that is too small grows.
void fit_into_block(Reader& reader, const Token& at, BlackHoleWarp& hole) {
  if (!hole.repeat) return;
  const Vec3 uncertainty = hole.turbulence.value_or(Vec3(0.0));
  for (int axis = 0; axis < 3; ++axis) {
    double& block = (*hole.repeat)[axis];
    if (block <= 0.0) continue;
    hole.center[axis] = std::max(hole.center[axis], hole.radius);
    const double least = hole.center[axis] + hole.radius + uncertainty[axis];
    if (block < least) {
      block = least;
      reader.warn(at,
                  std::string("'repeat' of a black hole is too small along ") + "xyz"[axis] + "; it is made larger");
    }
    if (block < kTinyLength) block = 0.0;
  }
}

BlackHoleWarp parse_black_hole(Reader& reader) {
  const Token& at = reader.peek();
  BlackHoleWarp hole;
  hole.center = finite_vector(reader, "black_hole");
  reader.skip_comma();
  hole.radius = finite_number(reader, "radius of 'black_hole'");
  for (;;) {
    if (reader.accept(Keyword::strength)) {
      hole.strength = finite_number(reader, "strength");
    } else if (reader.accept(Keyword::falloff)) {
      hole.falloff = finite_number(reader, "falloff");
    } else if (reader.accept(Keyword::inverse)) {
      hole.inverted = true;
    } else if (reader.accept(Keyword::type)) {
      hole.type = integer(reader, "type");
    } else if (reader.accept(Keyword::repeat)) {
      hole.repeat = finite_vector(reader, "repeat");
      fit_into_block(reader, at, hole);
    } else if (reader.accept(Keyword::turbulence)) {
      hole.turbulence = finite_vector(reader, "turbulence");
      fit_into_block(reader, at, hole);
    } else {
      return hole;
    }
  }
}

Turbulence parse_turbulence_warp(Reader& reader) {
  Turbulence turbulence;
  turbulence.amount = finite_vector(reader, "turbulence");
  while (accept_detail(reader, turbulence)) {
  }
  return turbulence;
}

/// The kind of warp with what belongs to it.
render::Warp parse_kind(Reader& reader, const Token& kind, Feature& feature) {
  switch (kind.keyword) {
    case Keyword::black_hole:
      feature = Feature::warp_black_hole;
      return parse_black_hole(reader);
    case Keyword::cubic:
      feature = Feature::warp_cubic;
      return render::CubicWarp();
    case Keyword::cylindrical:
      feature = Feature::warp_cylindrical;
      return parse_direction<render::CylindricalWarp>(reader);
    case Keyword::planar:
      feature = Feature::warp_planar;
      return parse_planar(reader);
    case Keyword::repeat:
      feature = Feature::warp_repeat;
      return parse_repeat(reader);
    case Keyword::spherical:
      feature = Feature::warp_spherical;
      return parse_direction<render::SphericalWarp>(reader);
    case Keyword::toroidal:
      feature = Feature::warp_toroidal;
      return parse_toroidal(reader);
    case Keyword::turbulence:
      feature = Feature::warp_turbulence;
      return parse_turbulence_warp(reader);
    default:
      reader.fail(kind, "expected a kind of warp, found " + describe(kind));
  }
}

void parse_warp(Reader& reader, const Token& word, Warps& warps) {
  reader.open_block(word);
  const Token& kind = reader.take();
  Feature feature{};
  warps.steps.push_back(parse_kind(reader, kind, feature));
  warps.unrendered.add(feature_use(feature, kind));
  reader.close_block();
}

constexpr std::size_t kMostSteps = 1000;

}  // namespace

bool accept_warp(Reader& reader, Warps& warps) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return false;
  switch (next.keyword) {
    case Keyword::warp: {
      const Token& word = reader.take();
      if (warps.steps.size() >= kMostSteps) reader.fail(word, "a pattern has more than 1000 warps");
      parse_warp(reader, word, warps);
      return true;
    }
    case Keyword::turbulence: {
      const Token& word = reader.take();
      if (!warps.turbulence) warps.turbulence.emplace();
      warps.turbulence->amount = finite_vector(reader, "turbulence");
      if (warps.turbulence->amount != Vec3(0.0)) warps.unrendered.add(feature_use(Feature::turbulence, word));
      return true;
    }
    case Keyword::octaves:
    case Keyword::omega:
    case Keyword::lambda:
      if (!warps.turbulence) warps.turbulence.emplace();
      return accept_detail(reader, *warps.turbulence);
    default:
      return false;
  }
}

}  // namespace firstlight::parser
