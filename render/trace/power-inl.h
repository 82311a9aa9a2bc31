// Powers and arc cosines, several at once. Included once for each instruction set, so the guard switches back and
// forth. Only additions, multiplications, divisions and square roots, none fused: every lane has the same bits on every
// machine, whatever stands in the other lanes.
#if defined(FIRSTLIGHT_RENDER_TRACE_POWER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_TRACE_POWER_INL_H
#undef FIRSTLIGHT_RENDER_TRACE_POWER_INL_H
#else
#define FIRSTLIGHT_RENDER_TRACE_POWER_INL_H
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The terms of a polynomial from kFirst on, kCount of them, less the factor x^kFirst. `powers` are x, x^2, x^4, ...
template <std::size_t kFirst, std::size_t kCount, class D, class V>
HWY_INLINE V terms(D d, const double* c, const V* powers) {
  if constexpr (kCount == 1) {
    return hn::Set(d, c[kFirst]);
  } else {
    constexpr std::size_t kHalf = std::bit_floor(kCount - 1);
    const V low = terms<kFirst, kHalf>(d, c, powers);
    const V high = terms<kFirst + kHalf, kCount - kHalf>(d, c, powers);
    return hn::Add(low, hn::Mul(high, powers[std::countr_zero(kHalf)]));
  }
}

/// c[0] + x c[1] + x^2 c[2] + ..., by halves: a chain of multiplications one inside the other would be waited for.
template <class D, class V, std::size_t kTerms>
HWY_INLINE V polynomial(D d, V x, const double (&c)[kTerms]) {
  static_assert(kTerms > 2 && kTerms <= 16);
  V powers[4] = {x, hn::Mul(x, x), x, x};
  if constexpr (kTerms > 4) powers[2] = hn::Mul(powers[1], powers[1]);
  if constexpr (kTerms > 8) powers[3] = hn::Mul(powers[2], powers[2]);
  return terms<0, kTerms>(d, c, powers);
}

/// Added to a double below 2^51 in size, it leaves the nearest integer in the low bits of the sum.
constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52

/// Logarithm to base 2 of x, within 1e-11 of itself. Pre: x is positive and not denormal.
template <class D, class V>
HWY_INLINE V log2_of(D d, V x) {
  const hn::RebindToSigned<D> di;
  // x = 2^e m with m between sqrt(1/2) and sqrt(2): the exponent is that of x / sqrt(1/2).
  constexpr std::int64_t kRootOfHalf = 0x3fe6a09e667f3bcd;
  constexpr std::int64_t kBias = std::int64_t{1024} << 52;  // keeps what is shifted positive
  const auto bits = hn::BitCast(di, x);
  const auto e =
      hn::ShiftRight<52>(hn::BitCast(hn::RebindToUnsigned<D>(), hn::Add(bits, hn::Set(di, kBias - kRootOfHalf))));
  const auto m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<52>(hn::Sub(hn::BitCast(di, e), hn::Set(di, 1024)))));
  // An integer in the low bits of 2^52 is 2^52 and that integer.
  constexpr std::int64_t kTwoTo52 = 0x4330000000000000;
  const auto exponent =
      hn::Sub(hn::BitCast(d, hn::Or(hn::BitCast(di, e), hn::Set(di, kTwoTo52))), hn::Set(d, 4503599627370496.0 + 1024));
  // ln m = 2 (s + s^3/3 + s^5/5 + ...), s = (m - 1) / (m + 1).
  constexpr double kTwiceLog2E = 2.885390081777926815;
  static constexpr double kSeries[] = {kTwiceLog2E,     kTwiceLog2E / 3,  kTwiceLog2E / 5, kTwiceLog2E / 7,
                                       kTwiceLog2E / 9, kTwiceLog2E / 11, kTwiceLog2E / 13};
  const auto one = hn::Set(d, 1.0);
  const auto s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  return hn::Add(exponent, hn::Mul(s, polynomial(d, hn::Mul(s, s), kSeries)));
}

/// 2^x, within 1e-11 of itself; 0 and infinity where a double has no room.
template <class D, class V>
HWY_INLINE V exp2_of(D d, V x) {
  const hn::RebindToSigned<D> di;
  const auto within = hn::Min(hn::Max(x, hn::Set(d, -1022.0)), hn::Set(d, 1023.0));
  const auto shifted = hn::Add(within, hn::Set(d, kRounder));
  const auto whole = hn::Sub(shifted, hn::Set(d, kRounder));
  constexpr double kLn2 = 0.693147180559945309;
  static constexpr double kSeries[] = {1.0,       1.0,        1.0 / 2,     1.0 / 6,      1.0 / 24,     1.0 / 120,
                                       1.0 / 720, 1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800};
  const auto part = polynomial(d, hn::Mul(hn::Sub(within, whole), hn::Set(d, kLn2)), kSeries);
  // The low bits of `shifted` are the exponent, and two's complement.
  const auto power = hn::BitCast(d, hn::ShiftLeft<52>(hn::Add(hn::BitCast(di, shifted), hn::Set(di, 1023))));
  const auto result = hn::Mul(part, power);
  const auto high =
      hn::IfThenElse(hn::Gt(x, hn::Set(d, 1023.0)), hn::Set(d, std::numeric_limits<double>::infinity()), result);
  return hn::IfThenElseZero(hn::Ge(x, hn::Set(d, -1022.0)), high);
}

/// x^y; x below 2^-1022 counts as 0.
template <class D, class V>
HWY_INLINE V power(D d, V x, V y) {
  const auto zero = hn::Zero(d);
  const auto positive = hn::Ge(x, hn::Set(d, std::numeric_limits<double>::min()));
  const auto result = exp2_of(d, hn::Mul(y, log2_of(d, hn::IfThenElse(positive, x, hn::Set(d, 1.0)))));
  const auto of_zero = hn::IfThenElse(
      hn::Gt(y, zero), zero,
      hn::IfThenElse(hn::Lt(y, zero), hn::Set(d, std::numeric_limits<double>::infinity()), hn::Set(d, 1.0)));
  return hn::IfThenElse(positive, result, of_zero);
}

/// Arc cosine of x in [-1, 1], within 2e-8.
/// Source   Abramowitz & Stegun, Handbook of Mathematical Functions, 4.4.46.
template <class D, class V>
HWY_INLINE V arc_cosine(D d, V x) {
  constexpr double kPi = 3.141592653589793238;
  static constexpr double kSeries[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                                       0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
  const auto size = hn::Min(hn::Abs(x), hn::Set(d, 1.0));
  const auto angle = hn::Mul(hn::Sqrt(hn::Sub(hn::Set(d, 1.0), size)), polynomial(d, size, kSeries));
  return hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, kPi), angle), angle);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
