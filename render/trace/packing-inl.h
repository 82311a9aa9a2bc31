// Numbers as ray tasks and the film keep them, packed several at once: PackedRgb, FixedRgb and PackedDirection.
// Included once for each instruction set, so the guard switches back and forth. The bits are the same on every machine.
#if defined(FIRSTLIGHT_RENDER_TRACE_PACKING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_TRACE_PACKING_INL_H
#undef FIRSTLIGHT_RENDER_TRACE_PACKING_INL_H
#else
#define FIRSTLIGHT_RENDER_TRACE_PACKING_INL_H
#endif

#include "render/math/fixed_rgb.h"
#include "render/trace/power-inl.h"
#include "render/trace/ray_task.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Triple {
  V x, y, z;
};

template <class V>
HWY_INLINE V dot(const Triple<V>& a, const Triple<V>& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

/// Integers as doubles hold them after kRounder was added.
template <class D, class V>
HWY_INLINE hn::VFromD<hn::RebindToSigned<D>> integer_of(D d, V with_rounder) {
  const hn::RebindToSigned<D> di;
  return hn::Sub(hn::BitCast(di, with_rounder), hn::BitCast(di, hn::Set(d, kRounder)));
}

/// A PackedRgb with its mantissas still apart.
template <class D>
struct Mantissas {
  using I = hn::RebindToSigned<D>;
  Triple<hn::VFromD<I>> of;
  hn::VFromD<I> exponent;  ///< biased; 0 for black, whose mantissas are 0
};

template <class D, class V>
HWY_INLINE Mantissas<D> mantissas_of(D d, const Triple<V>& color) {
  const hn::RebindToSigned<D> di;
  const auto r = hn::Abs(color.x);
  const auto g = hn::Abs(color.y);
  const auto b = hn::Abs(color.z);
  // Comparisons are false for what is no number.
  const auto endless = hn::Set(d, 0x1p128);
  const auto finite = hn::And(hn::Lt(r, endless), hn::And(hn::Lt(g, endless), hn::Lt(b, endless)));
  const auto most = hn::Max(r, hn::Max(g, b));
  constexpr int kDoubleBias = 1023;
  const auto seen = hn::And(finite, hn::Ge(most, hn::Set(d, 0x1p-110)));
  static_assert(int{PackedRgb::kSmallest} - int{PackedRgb::kBias} == -110);
  const auto exponent = hn::BitCast(di, hn::ShiftRight<52>(hn::BitCast(hn::RebindToUnsigned<D>(), most)));
  // The largest mantissa has all of its bits but the sign's.
  const auto scale =
      hn::BitCast(d, hn::ShiftLeft<52>(hn::Sub(hn::Set(di, 2 * kDoubleBias + PackedRgb::kMantissaBits - 2), exponent)));
  const auto largest = hn::Set(d, double{PackedRgb::kLargestMantissa});
  const auto rounded = [&](V component) HWY_ATTR {
    const auto scaled = hn::Max(hn::Min(hn::Mul(component, scale), largest), hn::Neg(largest));
    return hn::IfThenElseZero(hn::RebindMask(di, seen), integer_of(d, hn::Add(scaled, hn::Set(d, kRounder))));
  };
  const auto bias = hn::Set(di, kDoubleBias - static_cast<int>(PackedRgb::kBias));
  return {{rounded(color.x), rounded(color.y), rounded(color.z)},
          hn::IfThenElseZero(hn::RebindMask(di, seen), hn::Sub(exponent, bias))};
}

/// PackedRgb::bits().
template <class D>
HWY_INLINE hn::VFromD<hn::RebindToUnsigned<D>> packed(D, const Mantissas<D>& m) {
  const hn::RebindToUnsigned<D> du;
  constexpr int kBits = PackedRgb::kMantissaBits;
  const auto mask = hn::Set(du, (std::uint64_t{1} << kBits) - 1);
  const auto r = hn::And(hn::BitCast(du, m.of.x), mask);
  const auto g = hn::ShiftLeft<kBits>(hn::And(hn::BitCast(du, m.of.y), mask));
  const auto b = hn::ShiftLeft<2 * kBits>(hn::And(hn::BitCast(du, m.of.z), mask));
  return hn::Or(hn::Or(r, g), hn::Or(b, hn::ShiftLeft<3 * kBits>(hn::BitCast(du, m.exponent))));
}

template <class D>
HWY_INLINE Mantissas<D> unpacked(D, hn::VFromD<hn::RebindToUnsigned<D>> bits) {
  const hn::RebindToSigned<D> di;
  constexpr int kBits = PackedRgb::kMantissaBits;
  const auto b = hn::BitCast(di, bits);
  return {{hn::ShiftRight<64 - kBits>(hn::ShiftLeft<64 - kBits>(b)),
           hn::ShiftRight<64 - kBits>(hn::ShiftLeft<64 - 2 * kBits>(b)),
           hn::ShiftRight<64 - kBits>(hn::ShiftLeft<64 - 3 * kBits>(b))},
          hn::BitCast(di, hn::ShiftRight<3 * kBits>(bits))};
}

/// FixedRgb::from(PackedRgb).
template <class D>
HWY_INLINE Triple<hn::VFromD<hn::RebindToSigned<D>>> fixed(D d, const Mantissas<D>& m) {
  const hn::RebindToSigned<D> di;
  const auto shift = hn::Sub(m.exponent, hn::Set(di, PackedRgb::kExponentOfOne - FixedRgb::kStepBits));
  if (!hn::AllFalse(di, hn::Gt(shift, hn::Set(di, FixedRgb::kLargestShift)))) {
    // Absurdly bright; kept out of the way of the others.
    constexpr std::size_t kMost = 8;
    alignas(64) std::uint64_t bits[kMost];
    alignas(64) std::int64_t steps[3][kMost];
    hn::Store(packed(d, m), hn::RebindToUnsigned<D>(), bits);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      const FixedRgb all = FixedRgb::from(PackedRgb::from_bits(bits[i]));
      steps[0][i] = all.r;
      steps[1][i] = all.g;
      steps[2][i] = all.b;
    }
    return {hn::Load(di, steps[0]), hn::Load(di, steps[1]), hn::Load(di, steps[2])};
  }
  const auto zero = hn::Zero(di);
  const auto one = hn::Set(di, 1);
  const auto left = hn::Max(shift, zero);
  // A shift by more than FixedRgb does leaves nothing either, the largest by 63 included.
  const auto right = hn::Min(hn::Max(hn::Neg(shift), one), hn::Set(di, 63));
  const auto half = hn::Shl(one, hn::Sub(right, one));
  const auto upwards = hn::Gt(shift, hn::Set(di, -1));
  const auto shifted = [&](hn::VFromD<hn::RebindToSigned<D>> mantissa) HWY_ATTR {
    return hn::IfThenElse(upwards, hn::Shl(mantissa, left), hn::Shr(hn::Add(mantissa, half), right));
  };
  return {shifted(m.of.x), shifted(m.of.y), shifted(m.of.z)};
}

/// FixedRgb::to_fixed() of doubles.
template <class D, class V>
HWY_INLINE hn::VFromD<hn::RebindToSigned<D>> fixed_of(D d, V value) {
  const hn::RebindToSigned<D> di;
  const auto limit = hn::Set(d, double{FixedRgb::kLimit});
  const auto number = hn::IfThenElseZero(hn::Eq(value, value), value);
  const auto steps = hn::Mul(hn::Max(hn::Min(number, limit), hn::Neg(limit)), hn::Set(d, FixedRgb::kStepsPerUnit));
  return hn::ConvertTo(di, hn::Add(steps, hn::CopySign(hn::Set(d, 0.5), number)));
}

/// PackedDirection(direction): u in the low half of each lane, v in the high half.
template <class D, class V>
HWY_INLINE hn::VFromD<hn::RebindToSigned<D>> packed_direction(D d, const Triple<V>& direction) {
  const hn::RebindToSigned<D> di;
  const auto one = hn::Set(d, 1.0);
  const auto size = hn::Add(hn::Add(hn::Abs(direction.x), hn::Abs(direction.y)), hn::Abs(direction.z));
  const auto scale = hn::Div(one, size);
  const auto x = hn::Mul(direction.x, scale);
  const auto y = hn::Mul(direction.y, scale);
  const auto sign = [&](V v) HWY_ATTR { return hn::IfThenElse(hn::Ge(v, hn::Zero(d)), one, hn::Set(d, -1.0)); };
  const auto below = hn::Lt(direction.z, hn::Zero(d));
  const auto u = hn::IfThenElse(below, hn::Mul(hn::Sub(one, hn::Abs(y)), sign(x)), x);
  // Folded by the sign that y has before.
  const auto v = hn::IfThenElse(below, hn::Mul(hn::Sub(one, hn::Abs(x)), sign(y)), y);
  const auto steps = hn::Set(d, PackedDirection::kSteps);
  const auto rounder = hn::Set(d, kRounder);
  const auto low = hn::And(integer_of(d, hn::Add(hn::Mul(u, steps), rounder)), hn::Set(di, 0xffffffff));
  return hn::Or(low, hn::ShiftLeft<32>(integer_of(d, hn::Add(hn::Mul(v, steps), rounder))));
}

/// PackedDirection::unpack() of halves as above.
template <class D>
HWY_INLINE Triple<hn::VFromD<D>> unpacked_direction(D d, hn::VFromD<hn::RebindToSigned<D>> bits) {
  const hn::RebindToSigned<D> di;
  const auto number = [&](hn::VFromD<hn::RebindToSigned<D>> i) HWY_ATTR {
    return hn::Sub(hn::BitCast(d, hn::Add(i, hn::BitCast(di, hn::Set(d, kRounder)))), hn::Set(d, kRounder));
  };
  const auto step = hn::Set(d, 1.0 / PackedDirection::kSteps);
  auto x = hn::Mul(number(hn::ShiftRight<32>(hn::ShiftLeft<32>(bits))), step);
  auto y = hn::Mul(number(hn::ShiftRight<32>(bits)), step);
  const auto zero = hn::Zero(d);
  const auto one = hn::Set(d, 1.0);
  const auto z = hn::Sub(hn::Sub(one, hn::Abs(x)), hn::Abs(y));
  const auto fold = hn::Max(hn::Neg(z), zero);
  x = hn::Add(x, hn::IfThenElse(hn::Ge(x, zero), hn::Neg(fold), fold));
  y = hn::Add(y, hn::IfThenElse(hn::Ge(y, zero), hn::Neg(fold), fold));
  const Triple<hn::VFromD<D>> way{x, y, z};
  const auto inverse_length = hn::Div(one, hn::Sqrt(dot(way, way)));
  return {hn::Mul(x, inverse_length), hn::Mul(y, inverse_length), hn::Mul(z, inverse_length)};
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
