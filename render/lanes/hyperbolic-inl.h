// Hyperbolic functions, their inverses and the decimal logarithm over a lane type, as math-inl.h has the others. Included
// once for each instruction set, so the guard switches back and forth.
#if defined(FIRSTLIGHT_RENDER_LANES_HYPERBOLIC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_LANES_HYPERBOLIC_INL_H
#undef FIRSTLIGHT_RENDER_LANES_HYPERBOLIC_INL_H
#else
#define FIRSTLIGHT_RENDER_LANES_HYPERBOLIC_INL_H
#endif

#include "render/lanes/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Beyond, e^-x is nothing beside e^x; where e^x has no room, its half may have.
constexpr double kOneSided = 40.0;

/// e^x / 2 for an x that is not small.
template <class L>
HWY_INLINE L half_exponential(const L& x) {
  const L root = exponential(0.5 * x);
  return select(x > 700.0, 0.5 * root * root, 0.5 * exponential(x));
}

template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_sine(const L& x) {
  static constexpr double kSeries[] = {0.16666666666666665741,    0.0083333333333333332177, 0.0001984126984126977349,
                                       2.7557319224040339789e-6,  2.5052108364058039289e-8, 1.6059048396350562464e-10,
                                       7.6466253616566573078e-13, 2.8445264169895284539e-15};
  const L size = abs(x), t = x * x;
  const L half = half_exponential(size);
  const L large = copysign(select(size > kOneSided, half, half - 0.25 / half), x);
  return select(size < 1.0, select(t == 0.0, x, x + x * t * series(t, kSeries)), large);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_cosine(const L& x) {
  const L size = abs(x);
  const L half = half_exponential(size);
  return select(size > kOneSided, half, half + 0.25 / half);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_tangent(const L& x) {
  const L size = abs(x);
  const L within = min(size, L(kOneSided));
  const L large = copysign(1.0 - 2.0 / (exponential(2.0 * within) + 1.0), x);
  return select(x != x, x, select(size < 1.0, hyperbolic_sine(x) / hyperbolic_cosine(x), large));
}

/// ln(1 + x). The logarithm of what 1 + x is rounded to, corrected by how far that is from it.
template <class L>
HWY_INLINE L logarithm_beyond_1(const L& x) {
  const L sum = 1.0 + x;
  const L result = logarithm(sum) * (x / (sum - 1.0));
  return select(sum == 1.0, x, select(sum == kInfinite, sum, result));
}
constexpr double kLn2 = 0x1.62e42fefa39efp-1, kSquared = 1e150;

template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_arc_sine(const L& x) {
  const L size = abs(x), t = size * size;
  const L near = logarithm_beyond_1(size + t / (1.0 + sqrt(t + 1.0)));
  return copysign(select(size > kSquared, logarithm(size) + kLn2, near), x);
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_arc_cosine(const L& x) {
  const L t = x - 1.0;
  const L near = logarithm_beyond_1(t + sqrt(t * (t + 2.0)));
  return select(x < 1.0, L(kNoNumber), select(x > kSquared, logarithm(x) + kLn2, near));
}
template <class L>
FIRSTLIGHT_LANE_FUNCTION L hyperbolic_arc_tangent(const L& x) {
  const L size = abs(x);
  return copysign(0.5 * logarithm_beyond_1(2.0 * size / (1.0 - size)), x);
}

/// The logarithm to base 10; of powers of 10 it is whole.
template <class L>
HWY_INLINE L decimal_logarithm(const L& x) {
  constexpr double kHigh = 0x1.34413509f79ffp-2, kLow = -0x1.9dc1da994fd21p-59;  // log10(2)
  const MaskOf<L> is_plain = (x > 0.0) & (x < kInfinite);
  const Exact<L> log2 = exact_log2(select(is_plain, x, L(1.0)));
  const Exact<L> product = exact_product(log2.high, L(kHigh));
  const L result = product.high + (product.low + (log2.high * kLow + log2.low * kHigh));
  const L special = select(x == 0.0, L(-kInfinite), select(x > 0.0, x, L(kNoNumber)));
  return select(is_plain, result, special);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
