// The elementary functions over a lane type. Included once for each instruction set, so the guard switches back and forth.
//
// Those of the machine's library round their last digit as its processor allows; these have the same bits everywhere, and
// err by 2e-16 of the value at most (powers with large exponents by 1e-15), so that they mostly are the double that is
// nearest to it. Special cases (zeros, infinite numbers, what is no number) are those of <cmath>.
// Source   W. J. Cody & W. Waite, "Software manual for the elementary functions", 1980. Polynomials are Chebyshev
//          interpolations of what is left of each function behind its first terms.
#if defined(FIRSTLIGHT_RENDER_LANES_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_LANES_MATH_INL_H
#undef FIRSTLIGHT_RENDER_LANES_MATH_INL_H
#else
#define FIRSTLIGHT_RENDER_LANES_MATH_INL_H
#endif

#include "render/lanes/lanes-inl.h"
#include "render/lanes/quarter_turns.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

// Inlined into what calls them; but not where a sanitizer watches: with its code around every access compilers take
// minutes for some files.
#ifndef FIRSTLIGHT_LANE_FUNCTION
#ifdef FIRSTLIGHT_WATCHED
#define FIRSTLIGHT_LANE_FUNCTION HWY_NOINLINE
#else
#define FIRSTLIGHT_LANE_FUNCTION HWY_INLINE
#endif
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// The terms of a polynomial from kFirst on, kCount of them, less the factor x^kFirst. `powers` are x, x^2, x^4, ...
template <std::size_t kFirst, std::size_t kCount, class L>
HWY_INLINE L terms_of(const double* c, const L* powers) {
  if constexpr (kCount == 1) {
    return c[kFirst];
  } else {
    constexpr std::size_t kHalf = std::bit_floor(kCount - 1);
    return terms_of<kFirst, kHalf>(c, powers) +
           terms_of<kFirst + kHalf, kCount - kHalf>(c, powers) * powers[std::countr_zero(kHalf)];
  }
}

/// c[0] + x c[1] + x^2 c[2] + ..., by halves: a chain of multiplications one inside the other would be waited for.
template <class L, std::size_t kTerms>
HWY_INLINE L series(const L& x, const double (&c)[kTerms]) {
  static_assert(kTerms > 4 && kTerms <= 16);
  const L x2 = x * x, x4 = x2 * x2;
  const L powers[4] = {x, x2, x4, x4 * x4};
  return terms_of<0, kTerms>(c, powers);
}

/// Added to a double below 2^51 in size, it leaves the nearest whole number in the low bits of the sum.
constexpr double kWholeInBits = 6755399441055744.0;  // 1.5 * 2^52
template <class L>
HWY_INLINE L nearest_whole(const L& x) {
  return (x + kWholeInBits) - kWholeInBits;
}

/// 2^n for a whole number n from -1022 to 1023.
template <class L>
HWY_INLINE L two_to(const L& n) {
  return shift_bits_left<52>(n + (kWholeInBits + 1023.0));
}

/// x 2^n, rounded once, for a whole number n of up to some 2000 to either side.
template <class L>
HWY_INLINE L scaled(const L& x, const L& n) {
  const L half = nearest_whole(n * 0.5);
  return x * two_to(half) * two_to(n - half);
}

/// A sum of two numbers, of which the second is below the last digit of the first.
template <class L>
struct Exact {
  L high, low;
};
constexpr std::int64_t kUpperHalf = ~std::int64_t{0x7ffffff};

/// The product without any rounding.
template <class L>
HWY_INLINE Exact<L> exact_product(const L& a, const L& b) {
  const L a1 = and_bits(a, kUpperHalf), b1 = and_bits(b, kUpperHalf);
  const L a2 = a - a1, b2 = b - b1;
  const L product = a * b;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

/// a + b without any rounding, where |a| >= |b| or a is 0.
template <class L>
HWY_INLINE Exact<L> exact_sum(const L& a, const L& b) {
  const L sum = a + b;
  return {sum, (a - sum) + b};
}

/// e^(big + small) for |big| up to ln(2)/2 and a much smaller number, from 1/sqrt(2) to sqrt(2).
template <class L>
HWY_INLINE L exponential_near_0(const L& big, const L& small) {
  static constexpr double kSeries[] = {0.5,
                                       0.16666666666666665741,
                                       0.041666666666666678231,
                                       0.0083333333333333332177,
                                       0.0013888888888879003664,
                                       0.00019841269841263252014,
                                       0.000024801587336630948559,
                                       2.7557319247344507392e-6,
                                       2.7557263077309410113e-7,
                                       2.5052070959803662115e-8,
                                       2.0918212319133980235e-9,
                                       1.6086677666787362312e-10};
  const L r = big + small;
  const Exact<L> sum = exact_sum(L(1.0), big);
  return sum.high + (sum.low + (small + r * r * series(r, kSeries)));
}

/// e^x.
template <class L>
FIRSTLIGHT_LANE_FUNCTION L exponential(const L& x) {
  constexpr double kLog2E = 0x1.71547652b82fep+0, kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;
  const L within = clamp(x, -746.0, 710.0);
  const L n = nearest_whole(within * kLog2E);
  return scaled(exponential_near_0(within - n * kLn2High, -(n * kLn2Low)), n);
}

/// A positive number as 2^exponent (1 + f), where 1 + f lies between sqrt(1/2) and sqrt(2).
template <class L>
struct Parts {
  L exponent, f;
};
/// Pre: x is positive and finite.
template <class L>
HWY_INLINE Parts<L> parts_of(const L& x) {
  // The exponent is that of x / sqrt(1/2).
  constexpr std::int64_t kRootOfHalf = 0x3fe6a09e667f3bcd, kMantissa = 0x000fffffffffffff;
  constexpr std::int64_t kBias = std::int64_t{1024} << 52;  // keeps what is shifted positive
  constexpr double kNormal = std::numeric_limits<double>::min(), kRaise = 0x1p54;
  const MaskOf<L> is_tiny = x < kNormal;
  const L shifted = add_to_bits(select(is_tiny, x * kRaise, x), kBias - kRootOfHalf);
  // A whole number in the low bits of 2^52 is 2^52 and that number.
  const L exponent = or_bits(shift_bits_right<52>(shifted), 0x4330000000000000) - (0x1p52 + 1024.0);
  const L m = add_to_bits(and_bits(shifted, kMantissa), kRootOfHalf);
  return {exponent - select(is_tiny, L(54.0), L(0.0)), m - 1.0};
}

/// (artanh(s) / s - 1) / t for t = s^2, as far as parts_of() goes.
template <class L>
HWY_INLINE L artanh_series(const L& t) {
  static constexpr double kSeries[] = {0.33333333333333331483,  0.19999999999999995559,  0.14285714285717679428,
                                       0.11111111109929366902,  0.090909092968283811143, 0.076922875661650486068,
                                       0.066678193349199110784, 0.058440618214315551149, 0.059409986014807292243};
  return series(t, kSeries);
}

/// Natural logarithm.
template <class L>
FIRSTLIGHT_LANE_FUNCTION L logarithm(const L& x) {
  constexpr double kLn2High = 0x1.62e42fee00000p-1, kLn2Low = 0x1.a39ef35793c76p-33;
  const MaskOf<L> is_plain = (x > 0.0) & (x < kInfinite);
  const auto [exponent, f] = parts_of(select(is_plain, x, L(1.0)));
  // ln(1 + f) = 2 artanh(s), with f - f^2/2 taken out, which is exact enough to be added last.
  const L s = f / (f + 2.0);
  const L t = s * s;
  const L half_square = 0.5 * f * f;
  const L rest = s * (half_square + 2.0 * t * artanh_series(t));
  const L result = exponent * kLn2High - ((half_square - (rest + exponent * kLn2Low)) - f);
  // The logarithm of infinity is infinite, that of 0 is below all numbers, that of a negative number is none.
  const L special = select(x == 0.0, L(-kInfinite), select(x > 0.0, x, L(kNoNumber)));
  return select(is_plain, result, special);
}

/// Logarithm to base 2 in some twenty digits. Pre: x is positive and finite.
template <class L>
HWY_INLINE Exact<L> exact_log2(const L& x) {
  constexpr double kHigh = 0x1.7154760000000p+1, kLow = 0x1.4ae0bf85ddf44p-25, kTwiceLog2E = 0x1.71547652b82fep+1;
  const auto [exponent, f] = parts_of(x);
  const L below = f + 2.0;
  const L s = f / below;
  const L s1 = and_bits(s, kUpperHalf);
  // s2 is what s lacks to f / (2 + f): products with its upper half are exact, for `below` is taken in two parts too.
  const L below1 = and_bits(below, kUpperHalf), below2 = f - (below1 - 2.0);
  const L s2 = ((f - s1 * below1) - s1 * below2) / below;
  const L t = s * s;
  const L high = s1 * kHigh;
  const L low = s1 * kLow + s2 * kTwiceLog2E + s * t * artanh_series(t) * kTwiceLog2E;
  const L sum = exponent + high;
  const L lost = (exponent - sum) + high;  // the exponent is 0, or larger than what is added
  const L total = sum + (low + lost);
  return {total, (sum - total) + (low + lost)};
}

/// x^y.
template <class L>
FIRSTLIGHT_LANE_FUNCTION L power(const L& x, const L& y) {
  constexpr double kLn2 = 0x1.62e42fefa39efp-1, kLn2Low = 0x1.abc9e3b39803fp-56;
  constexpr double kSteepest = 1e25;  // more, and all powers are 0, 1 or infinite
  constexpr double kAllWhole = 0x1p53;
  const L size = abs(x);
  const MaskOf<L> is_plain = (size > 0.0) & (size < kInfinite);
  const Exact<L> log2 = exact_log2(select(is_plain, size, L(1.0)));
  const L steepness = clamp(y, -kSteepest, kSteepest);
  const Exact<L> product = exact_product(log2.high, steepness);
  const MaskOf<L> is_within = abs(product.high) < 1100.0;
  const L exponent = clamp(product.high, -1100.0, 1100.0);
  const L rest = select(is_within, product.low + log2.low * steepness, L(0.0));
  const L n = nearest_whole(exponent);
  const Exact<L> natural = exact_product(exponent - n, L(kLn2));
  const L small = natural.low + ((exponent - n) * kLn2Low + rest * kLn2);
  L result = scaled(exponential_near_0(natural.high, small), n);
  result = select(is_plain, result, select(y > 0.0, size, 1.0 / size));
  // Powers of negative numbers: of whole ones only, and odd ones are negative.
  const L half = y * 0.5;
  const MaskOf<L> is_whole = (abs(y) >= kAllWhole) | (trunc(y) == y);
  const MaskOf<L> is_odd = is_whole & (trunc(half) != half) & (abs(y) < kAllWhole);
  const MaskOf<L> is_negative = copysign(L(1.0), x) < 0.0;
  result = select(is_negative & is_odd, -result, result);
  result = select(is_negative & !is_whole & (size > 0.0) & (size < kInfinite), L(kNoNumber), result);
  result = select((x != x) | (y != y), x + y, result);
  return select((y == 0.0) | (x == 1.0) | ((x == -1.0) & (abs(y) == kInfinite)), L(1.0), result);
}

/// The part of numerator / denominator that `quotient` has lost by rounding.
template <class L>
HWY_INLINE L lost_in_quotient(const Exact<L>& numerator, const Exact<L>& denominator, const L& quotient) {
  const Exact<L> product = exact_product(quotient, denominator.high);
  return (((numerator.high - product.high) - product.low) + (numerator.low - quotient * denominator.low)) /
         denominator.high;
}

/// An angle less the nearest quarter turn, in two parts, and the number of these in the low bits of `turns`.
template <class L>
struct Angle {
  L rest, low, turns;
};
template <class L>
HWY_INLINE Angle<L> angle_of(const L& x) {
  constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
  // pi/2 in parts, of which the first two have 33 bits: products with numbers of 20 bits are exact.
  constexpr double kFirst = 0x1.921fb54400000p+0, kSecond = 0x1.0b4611a600000p-34, kThird = 0x1.3198a2e037073p-69;
  constexpr double kMost = 1e6;
  L turns = x * kTwoOverPi + kWholeInBits;
  const L n = turns - kWholeInBits;
  const Exact<L> near = exact_sum(x - n * kFirst, -(n * kSecond));
  const Exact<L> sum = exact_sum(near.high, near.low - n * kThird);
  L rest = select(n == 0.0, x, sum.high), low = select(n == 0.0, L(0.0), sum.low);
  const MaskOf<L> is_far = !(abs(x) <= kMost);
  if (any(is_far)) {
    turns = one_by_one(is_far, select(is_far, x, turns),
                       [](double far) { return quarter_turns(far).count + kWholeInBits; });
    rest = one_by_one(is_far, select(is_far, x, rest), [](double far) { return quarter_turns(far).rest; });
    low = one_by_one(is_far, select(is_far, x, low), [](double far) { return quarter_turns(far).low; });
  }
  return {rest, low, turns};
}

/// Sine and cosine of what is at most an eighth of a turn.
template <class L>
HWY_INLINE Exact<L> sine_near_0(const Angle<L>& angle) {
  static constexpr double kSeries[] = {-0.16666666666666665741,   0.008333333333333331483,   -0.00019841269841265016553,
                                       2.7557319219301918897e-6,  -2.5052106219521894941e-8, 1.6058529572267876551e-10,
                                       -7.5865765881710725068e-13};
  const L x = angle.rest, t = x * x;
  const L more = x * t * series(t, kSeries) + angle.low * (1.0 - 0.5 * t);
  const Exact<L> sum = exact_sum(x, more);
  return {select(t == 0.0, x, sum.high), sum.low};
}
template <class L>
HWY_INLINE Exact<L> cosine_near_0(const Angle<L>& angle) {
  static constexpr double kSeries[] = {0.041666666666666664354,  -0.0013888888888888887251, 0.000024801587301584618165,
                                       -2.755731922138211429e-7, 2.0876755783894037937e-9,  -1.14704597496756069e-11,
                                       4.7458048897606742665e-14};
  const L x = angle.rest, t = x * x;
  const Exact<L> large = exact_sum(L(1.0), -0.5 * t);
  return exact_sum(large.high, large.low + (t * t * series(t, kSeries) - x * angle.low));
}
/// Whether bit kBit of `turns` is set.
template <int kBit, class L>
HWY_INLINE MaskOf<L> turns_have(const L& turns) {
  constexpr std::int64_t kOne = 0x3ff0000000000000;
  return or_bits(and_bits(shift_bits_left<63 - kBit>(turns), std::numeric_limits<std::int64_t>::min()), kOne) < 0.0;
}
/// The sine of an angle so many quarter turns farther.
template <class L>
HWY_INLINE L sine_of(const Angle<L>& angle, double farther) {
  const L turns = angle.turns + farther;
  const L value = select(turns_have<0>(turns), cosine_near_0(angle).high, sine_near_0(angle).high);
  return select(turns_have<1>(turns), -value, value);
}

template <class L>
FIRSTLIGHT_LANE_FUNCTION L sine(const L& x) {
  return sine_of(angle_of(x), 0.0);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L cosine(const L& x) {
  return sine_of(angle_of(x), 1.0);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L tangent(const L& x) {
  const Angle<L> angle = angle_of(x);
  const Exact<L> sine = sine_near_0(angle), cosine = cosine_near_0(angle);
  const MaskOf<L> is_turned = turns_have<0>(angle.turns);
  const Exact<L> above = {select(is_turned, -cosine.high, sine.high), select(is_turned, -cosine.low, sine.low)};
  const Exact<L> below = {select(is_turned, sine.high, cosine.high), select(is_turned, sine.low, cosine.low)};
  const L quotient = above.high / below.high;
  return select(abs(quotient) > 1e-300, quotient + lost_in_quotient(above, below, quotient), quotient);
}

constexpr double kPiHigh = 0x1.921fb54442d18p+1, kPiLow = 0x1.1a62633145c07p-53;

/// The arc sine of |x| up to 1/2, and of sqrt((1 - |x|) / 2) beyond, which is half the angle to a quarter turn.
template <class L>
struct ArcSine {
  L large, more;  ///< its parts; the first is exact in 26 bits where x is not small
  MaskOf<L> is_small;
};
template <class L>
HWY_INLINE ArcSine<L> arc_sine_parts(const L& x) {
  static constexpr double kSeries[] = {0.16666666666666668517,   0.074999999999984329202, 0.044642857146355428843,
                                       0.030381944138531246508,  0.022372172942149888553, 0.017352392720869972559,
                                       0.013971212973552932929,  0.011479177415184905683, 0.010322814350185779281,
                                       0.0054575067186403581482, 0.017400879442694021371, -0.014851887071247203698,
                                       0.028757851367421566335};
  const L size = abs(x);
  const MaskOf<L> is_small = size < 0.5;
  const L t = select(is_small, size * size, (1.0 - size) * 0.5);
  const L root = select(is_small, size, sqrt(t));
  const L upper = select(is_small, size, and_bits(root, kUpperHalf));
  const L cut_off = select(is_small | (t == 0.0), L(0.0), (t - upper * upper) / (root + upper));
  return {upper, cut_off + root * t * series(t, kSeries), is_small};
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L arc_sine(const L& x) {
  const auto [large, more, is_small] = arc_sine_parts(x);
  const L far = 0.25 * kPiHigh - ((2.0 * more - 0.5 * kPiLow) - (0.25 * kPiHigh - 2.0 * large));
  return copysign(select(is_small, large + more, far), x);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L arc_cosine(const L& x) {
  const auto [large, more, is_small] = arc_sine_parts(x);
  const MaskOf<L> is_negative = x < 0.0;
  const L near =
      0.5 * kPiHigh - (select(is_negative, -large, large) - (0.5 * kPiLow - select(is_negative, -more, more)));
  const L far = select(is_negative, kPiHigh - 2.0 * (large + (more - 0.5 * kPiLow)), 2.0 * (large + more));
  return select(is_small, near, far);
}

/// The angle of (x, y) from the x axis, from -pi to pi.
template <class L>
FIRSTLIGHT_LANE_FUNCTION L arc_tangent(const L& y, const L& x) {
  static constexpr double kSeries[] = {-0.33333333333333331483, 0.19999999999999804046,   -0.14285714285659828482,
                                       0.11111111105155446754,  -0.090909087535008772929, 0.076922963750321426968,
                                       -0.06666424885738254924, 0.058789289978347751553,  -0.052304542706502442362,
                                       0.045515932206265492799, -0.03457056198142774428,  0.016285756855221027867};
  constexpr double kEighth = 0.4142135623730950488;  // tan(pi/8)
  constexpr double kLarge = 0x1p500, kSmall = 0x1p-500, kLower = 0x1p-600, kRaise = 0x1p600;
  const L width = abs(x), height = abs(y);
  const MaskOf<L> is_steep = height > width, is_back = copysign(L(1.0), x) < 0.0;
  L below = select(is_steep, height, width), above = select(is_steep, width, height);
  // Into the middle of what doubles can be: of infinite numbers only the quadrant or its middle is left.
  const MaskOf<L> is_large = below > kLarge, is_infinite = below == kInfinite;
  const L factor = select(is_large, L(kLower), select(below < kSmall, L(kRaise), L(1.0)));
  above = select(is_infinite, select(above == kInfinite, L(1.0), L(0.0)), above * factor);
  below = select(is_infinite, L(1.0), below * factor);
  // Beyond pi/8 the angle to pi/4 is the smaller one.
  const MaskOf<L> is_wide = above > kEighth * below;
  const L zero = 0.0;
  const Exact<L> difference = exact_sum(below, -above), sum = exact_sum(below, above);
  const Exact<L> numerator = {select(is_wide, -difference.high, above), select(is_wide, -difference.low, zero)};
  const Exact<L> denominator = {select(is_wide, sum.high, below), select(is_wide, sum.low, zero)};
  const L q = numerator.high / denominator.high;
  const L t = q * q;
  const MaskOf<L> is_exact = (abs(q) < 1e-250) | (below == 0.0);
  const L lost = select(is_exact, zero, lost_in_quotient(numerator, denominator, q));
  const L more = q * t * series(t, kSeries) + lost * (1.0 - t);
  // The angle goes up or down from a number of eighths of a turn.
  const MaskOf<L> is_down = without(is_steep, is_back) | without(is_back, is_steep);
  const L eighths = select(is_back, select(is_steep, L(2.0), L(4.0)), select(is_steep, L(2.0), zero)) +
                    select(is_wide, select(is_down, L(-1.0), L(1.0)), zero);
  const Exact<L> result = exact_sum(eighths * (0.25 * kPiHigh), select(is_down, -q, q));
  const L angle = result.high + (result.low + (select(is_down, -more, more) + eighths * (0.25 * kPiLow)));
  const L on_axis = select(is_back, L(kPiHigh), zero);
  return select((x != x) | (y != y), x + y, copysign(select(below == 0.0, on_axis, angle), y));
}
template <class L>
HWY_INLINE L arc_tangent(const L& x) {
  return arc_tangent(x, L(1.0));
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
