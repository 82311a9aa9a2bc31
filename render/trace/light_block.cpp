// Lights on many hits at once, and the feelers that take them back.

#include "render/lanes/math.h"
#include "render/math/point_hash.h"
#include "render/trace/hit_block.h"

// This file is compiled once for each instruction set; the best one that the machine has is chosen at run time. The
// answers are the same to the bit.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/trace/light_block.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/light/area_grid.h"
#include "render/trace/packing-inl.h"
#include "render/trace/power-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

using D = hn::CappedTag<double, 8>;
using I = hn::RebindToSigned<D>;
using U = hn::RebindToUnsigned<D>;
using V = hn::VFromD<D>;
using Mask = decltype(hn::Eq(hn::Zero(D()), hn::Zero(D())));
using Vec = Triple<V>;

template <class T>
HWY_INLINE auto load(const Column<T>& column, std::size_t i) {
  return hn::Load(hn::Rebind<T, D>(), column.at.data() + i);
}
template <class T>
HWY_INLINE auto load(const Columns3<T>& columns, std::size_t i) {
  return Triple<decltype(load(columns.of[0], i))>{load(columns.of[0], i), load(columns.of[1], i),
                                                  load(columns.of[2], i)};
}
template <class T, class Vector>
HWY_INLINE void store(const Vector& v, Column<T>& column, std::size_t i) {
  hn::Store(v, hn::Rebind<T, D>(), column.at.data() + i);
}
template <class T, class Vector>
HWY_INLINE void store(const Triple<Vector>& v, Columns3<T>& columns, std::size_t i) {
  store(v.x, columns.of[0], i);
  store(v.y, columns.of[1], i);
  store(v.z, columns.of[2], i);
}

template <class Vector>
HWY_INLINE Triple<Vector> operator+(const Triple<Vector>& a, const Triple<Vector>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
template <class Vector>
HWY_INLINE Triple<Vector> operator-(const Triple<Vector>& a, const Triple<Vector>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec operator*(const Vec& a, const Vec& b) {
  return {hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z)};
}
HWY_INLINE Vec operator*(const Vec& a, V b) { return {hn::Mul(a.x, b), hn::Mul(a.y, b), hn::Mul(a.z, b)}; }

/// `color`, or black. What a lane is not meant to have is masked, not multiplied by 0: 0 times infinity would make it
/// depend on its neighbours, for whose sake it is computed or left out.
HWY_INLINE Vec only_where(Mask mask, const Vec& color) {
  return {hn::IfThenElseZero(mask, color.x), hn::IfThenElseZero(mask, color.y), hn::IfThenElseZero(mask, color.z)};
}

HWY_INLINE bool any(Mask mask) { return !hn::AllFalse(D(), mask); }

/// In the light itself no direction leads to it; the zero vector stands for that, and gives no light.
HWY_INLINE V inverse_or_zero(V distance) {
  const D d;
  return hn::IfThenElseZero(hn::Gt(distance, hn::Zero(d)), hn::Div(hn::Set(d, 1.0), distance));
}

/// Share of the full light at a distance, as fading() has it.
HWY_INLINE V fading_at(const Light& light, V distance) {
  const D d;
  if (light.fade_distance < 0.0) {  // a power of a negative number
    alignas(64) double each[8];
    hn::Store(distance, d, each);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) each[i] = fading(light, each[i]);
    return hn::Load(d, each);
  }
  const V ratio = hn::Div(distance, hn::Set(d, light.fade_distance));
  return hn::Div(hn::Set(d, 2.0), hn::Add(hn::Set(d, 1.0), power(d, ratio, hn::Set(d, light.fade_power))));
}

/// The factor on a highlight's colour: the surface's colour as far as the finish is metallic and the angle steep, as
/// metallic_tint() has it.
template <bool kHasRare>
HWY_INLINE Vec tint_of(const LayerColumns& layer, std::size_t i, V cosine) {
  const D d;
  const V one = hn::Set(d, 1.0);
  if (!kHasRare) return {one, one, one};
  const V metallic = load(layer.metallic, i);
  if (!any(hn::Gt(metallic, hn::Zero(d)))) return {one, one, one};
  const V within = hn::Min(hn::Max(cosine, hn::Neg(one)), one);
  const V angle = hn::Mul(arc_cosine(d, within), hn::Set(d, 0.63661977236758134));  // 90 degrees is 1
  const V gap = hn::Sub(angle, hn::Set(d, 1.12));
  const V bare = hn::Sub(hn::Div(hn::Set(d, 0.014567225), hn::Mul(gap, gap)), hn::Set(d, 0.011612903));
  const V fresnel = hn::Min(hn::Max(bare, hn::Zero(d)), one);
  const V share = hn::IfThenElseZero(hn::Gt(metallic, hn::Zero(d)), hn::Mul(metallic, hn::Sub(one, fresnel)));
  const Vec white{one, one, one};
  return white + (load(layer.color, i) - white) * share;
}

/// The hits of one vector under one light.
struct Lit {
  Vec to_light;  ///< unit
  V cosine;      ///< to the normal
  V least;       ///< the least cosine under which the light shines on the front
  Mask behind;
  Mask used;                ///< lanes that stand for a hit; the others hold anything
  std::uint64_t light = 0;  ///< its number; of a point of a light also the point's, from bit 32 on
  bool highlights;
};

/// Highlight by the mirrored eye ray: phong * (R.L)^phong_size.
HWY_INLINE V phong(const LayerColumns& layer, std::size_t i, const Lit& lit, const Vec& mirrored, V amount) {
  const D d;
  const V cosine = dot(mirrored, lit.to_light);
  const V size = load(layer.phong_size, i);
  // Small cosines to large powers are left out, as POV-Ray does.
  const Mask lost = hn::And(hn::Ge(size, hn::Set(d, 60.0)), hn::Le(cosine, hn::Set(d, 0.0008)));
  const Mask seen = hn::And(hn::AndNot(lost, hn::Gt(cosine, hn::Zero(d))), hn::Ne(amount, hn::Zero(d)));
  return hn::IfThenElseZero(seen, hn::Mul(amount, power(d, cosine, size)));
}

/// Highlight by the vector halfway between eye and light: specular * (N.H)^(1/roughness).
HWY_INLINE V specular(const LayerColumns& layer, std::size_t i, const Lit& lit, const Vec& direction, const Vec& normal,
                      V amount) {
  const D d;
  const Vec halfway = lit.to_light - direction;
  // The power of the cosine's square, to half the exponent: one square root less.
  const V along = dot(halfway, normal);
  const V square = hn::Div(hn::Mul(along, along), dot(halfway, halfway));
  const V exponent = hn::Mul(load(layer.specular_exponent, i), hn::Set(d, 0.5));
  const Mask seen = hn::And(hn::Gt(along, hn::Zero(d)), hn::Ne(amount, hn::Zero(d)));
  return hn::IfThenElseZero(seen, hn::Mul(amount, power(d, square, exponent)));
}

/// Tints white light by interference in a thin film: 1 + irid cos(2 pi film (|n.l| + |n.e|) / wavelength).
HWY_INLINE Vec film_tint(const HitBlock& block, const LayerColumns& layer, std::size_t i, const Lit& lit,
                         const Vec& normal) {
  const D d;
  alignas(64) double cosines[8];
  alignas(64) double tints[3][8] = {};
  hn::Store(hn::Add(hn::Abs(lit.cosine), hn::Abs(dot(normal, load(block.direction, i)))), d, cosines);
  for (std::size_t k = 0; k < hn::Lanes(d) && i + k < block.size; ++k) {
    const double irid = layer.irid[i + k];
    const double way = 2.0 * std::numbers::pi * layer.film[i + k] * cosines[k];
    for (int c = 0; c < 3; ++c)
      tints[c][k] = irid == 0.0 ? 1.0 : 1.0 + irid * steady::cosine(way / block.irid_wavelength[c]);
  }
  return {hn::Load(d, tints[0]), hn::Load(d, tints[1]), hn::Load(d, tints[2])};
}

/// The part of the diffuse light of one light that chance takes.
HWY_INLINE V chance(const HitBlock& block, const LayerColumns& layer, std::size_t i, const Lit& lit, V most) {
  alignas(64) double taken[8] = {};
  hn::Store(most, D(), taken);
  const auto number = static_cast<std::uint64_t>(&layer - block.layers.data());
  for (std::size_t k = 0; k < hn::Lanes(D()) && i + k < block.size; ++k) {
    if (taken[k] != 0.0) taken[k] *= hashed_number(block.point.vector(i + k), lit.light << 16 | number);
  }
  return hn::Load(D(), taken);
}

/// The light that one layer makes of white light, times the ray's weight. `kHasRare`: the layer's has_rare.
template <bool kHasRare>
HWY_INLINE Vec term_of(const HitBlock& block, const LayerColumns& layer, std::size_t i, const Lit& lit,
                       const Vec& normal, const Vec& mirrored) {
  const D d;
  const V zero = hn::Zero(d);
  V falloff = hn::Abs(lit.cosine);
  V back = zero;
  if (kHasRare) {
    const V brilliance = load(layer.brilliance, i);
    const Mask plain = hn::Eq(brilliance, hn::Set(d, 1.0));
    if (any(hn::AndNot(plain, lit.used))) falloff = hn::IfThenElse(plain, falloff, power(d, falloff, brilliance));
    back = load(layer.diffuse_back, i);
  }
  const V amount = hn::IfThenElse(lit.behind, back, load(layer.diffuse, i));
  V intensity = hn::Mul(falloff, amount);
  Mask shone_on = hn::Ne(amount, zero);
  if (kHasRare) {
    const V crand = hn::IfThenElse(lit.behind, load(layer.crand_back, i), load(layer.crand, i));
    const Mask drawn = hn::Ne(crand, zero);
    if (any(hn::And(lit.used, drawn))) {
      intensity = hn::Sub(intensity, chance(block, layer, i, lit, crand));
      shone_on = hn::Or(shone_on, drawn);
    }
  }
  Vec term = only_where(shone_on, load(layer.color, i) * intensity);
  if (lit.highlights) {
    // Which highlights there are is asked of the surfaces alone: whether they face the light cannot be foretold.
    const V shine = kHasRare ? load(layer.phong, i) : zero;
    const V gloss = load(layer.specular, i);
    const bool any_shine = any(hn::And(lit.used, hn::Gt(shine, zero)));
    const bool any_gloss = any(hn::And(lit.used, hn::Gt(gloss, zero)));
    if (any_shine || any_gloss) {
      const auto in_front = [&](V strength) HWY_ATTR {
        return hn::IfThenElseZero(hn::AndNot(lit.behind, hn::Gt(strength, zero)), strength);
      };
      V highlight = zero;
      if (any_shine) highlight = phong(layer, i, lit, mirrored, in_front(shine));
      if (any_gloss) {
        highlight = hn::Add(highlight, specular(layer, i, lit, load(block.direction, i), normal, in_front(gloss)));
      }
      term = term + only_where(hn::Ne(highlight, zero), tint_of<kHasRare>(layer, i, lit.cosine) * highlight);
    }
  }
  if (kHasRare && any(hn::And(lit.used, hn::Ne(load(layer.irid, i), zero)))) {
    term = term * film_tint(block, layer, i, lit, normal);
  }
  return load(layer.share, i) * term;
}

HWY_INLINE Vec mirrored_at(const HitBlock& block, const Vec& normal, std::size_t i) {
  const Vec direction = load(block.direction, i);
  return direction - normal * hn::Mul(hn::Set(D(), 2.0), dot(direction, normal));
}

/// The same for all layers, by their own normals where they have some.
HWY_NOINLINE Vec uncommon_term_of(const HitBlock& block, const LayerColumns& layer, std::size_t i, const Lit& lit,
                                  const Vec& normal, const Vec& mirrored) {
  if (layer.tilted == 0) return term_of<true>(block, layer, i, lit, normal, mirrored);
  const Vec own = load(layer.normal, i);
  Lit tilted = lit;
  tilted.cosine = dot(own, lit.to_light);
  tilted.behind = hn::Lt(tilted.cosine, lit.least);
  return layer.has_rare ? term_of<true>(block, layer, i, tilted, own, mirrored_at(block, own, i))
                        : term_of<false>(block, layer, i, tilted, own, mirrored_at(block, own, i));
}

HWY_INLINE Vec layer_term_of(const HitBlock& block, const LayerColumns& layer, std::size_t i, const Lit& lit,
                             const Vec& normal, const Vec& mirrored) {
  if (layer.has_rare || layer.tilted != 0) return uncommon_term_of(block, layer, i, lit, normal, mirrored);
  return term_of<false>(block, layer, i, lit, normal, mirrored);
}

/// The lanes whose bit is set, from bit 0 on.
HWY_INLINE Mask lanes_of(std::uint64_t bits) {
  const U d;
  return hn::RebindMask(D(), hn::Ne(hn::And(hn::Set(d, bits), hn::Shl(hn::Set(d, 1), hn::Iota(d, 0))), hn::Zero(d)));
}

/// False for black, for what is too faint for PackedRgb, and where a channel is endless or not a number: that is black.
HWY_INLINE Mask is_some(const Vec& color) {
  const D d;
  const V size = hn::Add(hn::Add(hn::Abs(color.x), hn::Abs(color.y)), hn::Abs(color.z));
  return hn::And(hn::Ge(size, hn::Set(d, 0x1p-110)), hn::Lt(size, hn::Set(d, 0x1p127)));
}

template <class M>
HWY_INLINE unsigned bits_of(M mask) {
  std::uint8_t byte[8] = {};
  hn::StoreMaskBits(U(), mask, byte);
  return byte[0];
}

/// RadianceBound::at_stake() of records of feelers.
struct AtStake {
  Triple<hn::VFromD<I>> sum;
  hn::VFromD<I> feelers;

  HWY_INLINE AtStake() : sum{hn::Zero(I()), hn::Zero(I()), hn::Zero(I())}, feelers(hn::Zero(I())) {}
  template <class Feelers>
  HWY_INLINE void add(Feelers is_feeler, const Triple<hn::VFromD<I>>& steps) {
    const I di;
    const auto there = hn::RebindMask(di, is_feeler);
    const auto size = [&](auto v) HWY_ATTR { return hn::IfThenElseZero(there, hn::Abs(v)); };
    sum = sum + Triple<hn::VFromD<I>>{size(steps.x), size(steps.y), size(steps.z)};
    feelers = hn::Add(feelers, hn::IfThenElseZero(there, hn::Set(di, 1)));
  }
  HWY_INLINE hn::VFromD<I> most(bool may_gain) const {
    const auto held = hn::Max(sum.x, hn::Max(sum.y, sum.z));
    return hn::Add(feelers, may_gain ? hn::Add(held, hn::ShiftRight<2>(held)) : held);
  }
};

void begin_light_of(HitBlock& block) {
  const D d;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(d)) {
    store(packed_direction(d, mirrored_at(block, load(block.normal, i), i)), block.mirrored, i);
    const Vec own = load(block.own_light, i);
    store(Triple<hn::VFromD<I>>{fixed_of(d, own.x), fixed_of(d, own.y), fixed_of(d, own.z)}, block.sum, i);
  }
}

/// A light's data that every vector of hits asks for, close together.
struct Shining {
  Vec3 position;
  Vec3 color;
  std::uint64_t reached;
  bool is_plain;
  bool fades;
  bool is_spread;
  bool is_sure;
  bool highlights;
  bool both_sides;

  Shining() = default;
  Shining(const Light& light, std::uint64_t shines_on)
      : position(light.position),
        color(light.color),
        reached(shines_on),
        is_plain(render::is_plain(light)),
        fades(render::fades(light)),
        is_spread(has_spread_light(light)),
        is_sure(render::is_sure(light)),
        highlights(!light.shadowless),
        both_sides(lights_both_sides(light)) {}
};

HWY_INLINE Vec all_lanes(const Vec3& v) {
  const D d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

/// The light that all layers make of white light, times the ray's weight.
HWY_INLINE Vec terms_of(const HitBlock& block, std::size_t i, const Lit& lit, const Vec& normal, const Vec& mirrored) {
  Vec terms = layer_term_of(block, block.layers[0], i, lit, normal, mirrored);
  for (std::size_t k = 1; k < block.layer_count; ++k) {
    terms = terms + layer_term_of(block, block.layers[k], i, lit, normal, mirrored);
  }
  return terms;
}

/// Adds what the hits make of light that is white and comes as `arrival` says.
void add_arrival_of(const HitBlock& block, const Arrival& arrival, std::uint64_t light, bool highlights,
                    Columns3<double>& sum) {
  const D d;
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(d)) {
    const Vec normal = load(block.normal, i);
    Lit lit;
    lit.used = hn::FirstN(d, block.size - i);
    lit.to_light = load(arrival.direction, i);
    lit.cosine = dot(normal, lit.to_light);
    lit.least = load(block.lit_from, i);
    lit.behind = hn::Lt(lit.cosine, lit.least);
    lit.highlights = highlights;
    lit.light = light;
    const Vec terms = terms_of(block, i, lit, normal, mirrored_at(block, normal, i));
    const V share = load(arrival.share, i);
    store(load(sum, i) + only_where(hn::Ne(share, hn::Zero(d)), terms * share), sum, i);
  }
}

void light_hits_of(HitBlock& block, std::span<const Light> lights) {
  const D d;
  constexpr double kNegligible = 1e-10;
  std::fill_n(block.open.begin(), lights.size(), 0u);
  std::array<Shining, kLightsAtOnce> shining;
  for (std::size_t l = 0; l < lights.size(); ++l) shining[l] = Shining(lights[l], block.reached[l]);
  for (std::size_t i = 0; i < block.size; i += hn::Lanes(d)) {
    const Vec point = load(block.point, i);
    const Vec normal = load(block.normal, i);
    const Vec mirrored = mirrored_at(block, normal, i);
    Lit lit;
    lit.used = hn::FirstN(d, block.size - i);
    auto sum = load(block.sum, i);
    Vec sure{hn::Zero(d), hn::Zero(d), hn::Zero(d)};  // light that no feeler takes back
    AtStake at_stake;
    for (std::size_t l = 0; l < lights.size(); ++l) {
      const Shining& light = shining[l];
      Vec color = all_lanes(light.color);
      if (light.is_plain) {
        const Vec way = all_lanes(light.position) - point;
        const V distance = hn::Sqrt(dot(way, way));
        if (light.fades && !light.is_spread) color = color * fading_at(lights[l], distance);
        lit.to_light = way * inverse_or_zero(distance);
      } else {
        if (!light.is_spread) color = color * load(block.arrivals[l].share, i);
        lit.to_light = load(block.arrivals[l].direction, i);
      }
      lit.cosine = dot(normal, lit.to_light);
      lit.least = light.both_sides ? hn::Set(d, -2.0) : load(block.lit_from, i);
      lit.behind = hn::Lt(lit.cosine, lit.least);
      lit.highlights = light.highlights;
      lit.light = block.first_light + l;
      if (!light.is_spread && !block.lit_from_behind && !light.both_sides &&
          hn::AllFalse(d, hn::AndNot(lit.behind, lit.used))) {
        continue;
      }
      const Vec term = light.is_spread ? load(block.spread_light[l], i) : terms_of(block, i, lit, normal, mirrored);
      const Mask shines =
          hn::Ge(hn::Max(hn::Abs(color.x), hn::Max(hn::Abs(color.y), hn::Abs(color.z))), hn::Set(d, kNegligible));
      color = only_where(shines, color * term);
      Mask is_light = hn::And(lit.used, is_some(color));
      if (light.reached != ~std::uint64_t{0}) is_light = hn::And(is_light, lanes_of(light.reached >> i));
      if (light.is_sure) {
        sure = sure + only_where(is_light, color);
        continue;
      }
      const Mask is_clear = lanes_of(block.foreseen[l].clear >> i);
      const Mask is_blocked = lanes_of(block.foreseen[l].blocked >> i);
      block.clear_feelers += hn::CountTrue(d, hn::And(is_light, is_clear));
      block.blocked_feelers += hn::CountTrue(d, hn::And(is_light, is_blocked));
      sure = sure + only_where(hn::And(is_light, is_clear), color);
      const Mask is_open = hn::AndNot(hn::Or(is_clear, is_blocked), is_light);
      if (!any(is_open)) continue;
      const Mantissas<D> mantissas = mantissas_of(d, only_where(is_open, color));
      const auto steps = fixed(d, mantissas);
      const auto bits = packed(d, mantissas);
      const auto is_feeler = hn::Ne(bits, hn::Zero(U()));
      sum = sum + steps;
      at_stake.add(is_feeler, steps);
      block.open[l] |= std::uint64_t{bits_of(is_feeler)} << i;
      store(bits, block.light[l], i);
    }
    sum = sum + Triple<hn::VFromD<I>>{fixed_of(d, sure.x), fixed_of(d, sure.y), fixed_of(d, sure.z)};
    store(sum, block.sum, i);
    store(at_stake.most(block.feelers_may_gain), block.at_stake, i);
  }
}

void aim_feelers_at(FeelerBlock& block, std::span<const LightPlace> lights) {
  const D d;
  const I di;
  const double* places = lights.front().data();
  RayBlock& rays = block.rays;
  for (std::size_t i = 0; i < rays.size; i += hn::Lanes(d)) {
    const auto used = hn::RebindMask(di, hn::FirstN(d, rays.size - i));
    const auto place = hn::ShiftLeft<3>(hn::IfThenElseZero(used, load(block.light, i)));
    const auto number = [&](int k) HWY_ATTR { return hn::GatherIndex(d, places + k, place); };
    const Vec way = Vec{number(0), number(1), number(2)} - load(rays.origin, i);
    V distance = hn::Sqrt(dot(way, way));
    Vec direction = way * inverse_or_zero(distance);
    const Mask parallel = hn::Gt(number(3), hn::Zero(d));
    if (any(parallel)) {
      const Vec axis{number(4), number(5), number(6)};
      distance = hn::IfThenElse(parallel, dot(way, axis), distance);
      direction = {hn::IfThenElse(parallel, axis.x, direction.x), hn::IfThenElse(parallel, axis.y, direction.y),
                   hn::IfThenElse(parallel, axis.z, direction.z)};
    }
    const V gap = hn::Set(d, kShadowGap);
    store(direction, rays.direction, i);
    store(gap, rays.min_depth, i);
    store(hn::Sub(distance, gap), rays.max_depth, i);
    store(hn::Set(di, kHiddenFromShadow), rays.hidden_bit, i);
  }
}

void weigh_feelers_of(FeelerBlock& block) {
  const D d;
  for (std::size_t i = 0; i < block.size(); i += hn::Lanes(d)) {
    store(fixed(d, unpacked(d, load(block.at_stake, i))), block.steps, i);
  }
}

void unpack_directions_of(const Column<std::int64_t>& packed, std::size_t count, Columns3<double>& directions) {
  const D d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) store(unpacked_direction(d, load(packed, i)), directions, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "render/math/interrupt.h"

#include <memory>
#include <vector>

namespace firstlight::render {

HWY_EXPORT(begin_light_of);
HWY_EXPORT(add_arrival_of);
HWY_EXPORT(light_hits_of);
HWY_EXPORT(aim_feelers_at);
HWY_EXPORT(weigh_feelers_of);
HWY_EXPORT(unpack_directions_of);

void begin_light(HitBlock& block) { HWY_DYNAMIC_DISPATCH(begin_light_of)(block); }

namespace {

/// Adds up what the hits make of a white light that is spread over an area, each point of it lighting for itself.
void find_spread_light(HitBlock& block, const Light& light, std::uint64_t number, Columns3<double>& sum) {
  for (Column<double>& column : sum.of) std::fill_n(column.at.begin(), block.capacity, 0.0);
  const AreaLight& area = *light.area;
  std::vector<AreaGrid> grids;
  grids.reserve(block.size);
  for (std::size_t i = 0; i < block.size; ++i) {
    grids.emplace_back(light, block.point.vector(i), AreaGrid::Use::illumination);
  }
  const double part = 1.0 / (static_cast<double>(area.size1) * static_cast<double>(area.size2));
  const auto arrival = std::make_unique_for_overwrite<Arrival>();
  const auto places = std::make_unique_for_overwrite<Columns3<double>>();
  std::uint64_t point = 0;
  for (int v = 0; v < area.size2; ++v) {
    for (int u = 0; u < area.size1 && !Interrupt::asked(); ++u) {
      for (std::size_t i = 0; i < block.size; ++i) places->set(i, grids[i].place(u, v));
      arrive(light, block.point, block.size, places.get(), *arrival);
      for (std::size_t i = 0; i < block.size; ++i) arrival->share[i] *= part;
      HWY_DYNAMIC_DISPATCH(add_arrival_of)(block, *arrival, number | ++point << 32, !light.shadowless, sum);
    }
  }
}

}  // namespace

void light_hits(HitBlock& block, std::span<const Light> lights) {
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Light& light = lights[l];
    if (!is_plain(light)) {
      if (block.arrivals.empty()) block.arrivals.resize(kLightsAtOnce);
      arrive(light, block.point, block.size, nullptr, block.arrivals[l]);
    }
    if (has_spread_light(light)) {
      if (block.spread_light.empty()) block.spread_light.resize(kLightsAtOnce);
      find_spread_light(block, light, block.first_light + l, block.spread_light[l]);
    }
  }
  HWY_DYNAMIC_DISPATCH(light_hits_of)(block, lights);
}

LightPlace place_of(const Light& light) {
  const Vec3& at = light.position;
  if (!light.parallel) return {at.x, at.y, at.z};
  const Vec3 axis = aim_at(light, at, at).direction;
  return {at.x, at.y, at.z, 1.0, axis.x, axis.y, axis.z};
}

void aim_feelers(FeelerBlock& block, std::span<const LightPlace> lights) {
  HWY_DYNAMIC_DISPATCH(aim_feelers_at)(block, lights);
}

void weigh_feelers(FeelerBlock& block) { HWY_DYNAMIC_DISPATCH(weigh_feelers_of)(block); }

void unpack_directions(const Column<std::int64_t>& packed, std::size_t count, Columns3<double>& directions) {
  HWY_DYNAMIC_DISPATCH(unpack_directions_of)(packed, count, directions);
}

}  // namespace firstlight::render
#endif
