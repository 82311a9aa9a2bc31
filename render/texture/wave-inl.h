// Waves over a lane type; render/texture/wave.h says what they are. Included once for each instruction set, so the guard
// switches back and forth.
#if defined(FIRSTLIGHT_RENDER_TEXTURE_WAVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_TEXTURE_WAVE_INL_H
#undef FIRSTLIGHT_RENDER_TEXTURE_WAVE_INL_H
#else
#define FIRSTLIGHT_RENDER_TEXTURE_WAVE_INL_H
#endif

#include "render/lanes/math-inl.h"
#include "render/texture/wave.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// One period of the phase. A little above 1, so that the value 1 of a pattern is not folded to 0. [POV-Ray 3.7]
constexpr double kWavePeriod = 1.00001;

/// fmod(x, 1).
template <class L>
HWY_INLINE L fraction_towards_0(const L& x) {
  const L rest = x - trunc(x);
  return select(abs(x) < kInfinite, copysign(rest, x), L(kNoNumber));
}

/// fmod(x, kWavePeriod), exactly.
template <class L>
HWY_INLINE L within_period(const L& x) {
  // Products of the period's halves with whole numbers below 2^25 are exact, and so are the differences.
  constexpr double kMost = 0x1p25, kHigh = 0x1.0000a7c000000p+0, kLow = kWavePeriod - kHigh;
  const L size = abs(x);
  const L whole = trunc(size / kWavePeriod);
  L rest = (size - whole * kHigh) - whole * kLow;
  rest = select(rest < 0.0, rest + kWavePeriod, rest);
  rest = select(rest >= kWavePeriod, rest - kWavePeriod, rest);
  L result = copysign(select(whole == 0.0, size, rest), x);
  const MaskOf<L> is_far = !(size < kMost);
  if (any(is_far)) {
    result = one_by_one(is_far, select(is_far, x, result), [](double far) { return std::fmod(far, kWavePeriod); });
  }
  return result;
}

/// sin(2 pi value).
template <class L>
HWY_INLINE L sine_wave(const L& value) {
  return sine(2.0 * kPiHigh * (value - floor(value)));
}
/// Up from 0 to 1 and down again within a period of 1.
template <class L>
HWY_INLINE L triangle_wave(const L& value) {
  const L along = value - floor(value);
  return select(along >= 0.5, 2.0 * (1.0 - along), 2.0 * along);
}

/// The place in the map for a bare value, by a wave whose numbers have been rounded to single precision.
template <class L>
HWY_INLINE L shaped(const Wave& wave, L value) {
  if (wave.frequency != 0.0) value = within_period(value * wave.frequency + wave.phase);
  value = select(value < 0.0, value - floor(value), value);
  switch (wave.form) {
    case WaveForm::ramp:
      return value;
    case WaveForm::triangle:
      return triangle_wave(value);
    case WaveForm::sine:
      return 0.5 * (1.0 + sine_wave(value));
    case WaveForm::scallop:
      return abs(sine_wave(0.5 * value));
    case WaveForm::cubic:
      return value * value * (3.0 - 2.0 * value);
    case WaveForm::poly:
      return power(value, L(wave.exponent));
  }
  return value;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
