#include "render/lanes/quarter_turns.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace firstlight::render {
namespace {

/// The bits of 2/pi behind the point.
constexpr std::uint64_t kTwoOverPi[] = {0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
                                        0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484,
                                        0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f,
                                        0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d, 0x7527bac7ebe5f17b,
                                        0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};
constexpr int kWordBits = 64;

/// 64 of them from bit `first` on; those before the point are 0.
std::uint64_t bits_from(int first) {
  const auto word = [](int i) { return i < 0 ? 0 : kTwoOverPi[i]; };
  const int index = first >= 0 ? first / kWordBits : (first - kWordBits + 1) / kWordBits;
  const int within = first - index * kWordBits;
  if (within == 0) return word(index);
  return word(index) << within | word(index + 1) >> (kWordBits - within);
}

__extension__ using Wide = unsigned __int128;

}  // namespace

QuarterTurns quarter_turns(double angle) {
  if (!std::isfinite(angle)) return {0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  int exponent = 0;
  // |angle| is a whole number of 53 bits times 2^exponent.
  const auto whole = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(angle), &exponent), 53));
  exponent -= 53;
  // Bits of 2/pi that stand for whole turns whatever they are multiplied with are left out; of the product with the 192
  // bits behind them the highest two are quarter turns.
  const int first = exponent - 2;
  const Wide lower = Wide{whole} * bits_from(first + 2 * kWordBits);
  const Wide middle = Wide{whole} * bits_from(first + kWordBits) + (lower >> kWordBits);
  const std::uint64_t upper = whole * bits_from(first) + static_cast<std::uint64_t>(middle >> kWordBits);
  int count = static_cast<int>(upper >> (kWordBits - 2));
  std::uint64_t part[3] = {
      upper << 2 | static_cast<std::uint64_t>(middle) >> (kWordBits - 2),
      static_cast<std::uint64_t>(middle) << 2 | static_cast<std::uint64_t>(lower) >> (kWordBits - 2),
      static_cast<std::uint64_t>(lower) << 2};
  const bool is_above_half = part[0] >> (kWordBits - 1) != 0;
  if (is_above_half) {
    ++count;
    // The way to the next, as a number of 192 bits. That the last bit is missing does not show.
    for (std::uint64_t& word : part) word = ~word;
  }
  // The first 128 bits from the highest that is set on, as a sum of two doubles. So many zeros lead no angle's.
  int leading = std::countl_zero(part[0]);
  if (leading == kWordBits) {
    leading += std::countl_zero(part[1]);
    part[0] = part[1];
    part[1] = part[2];
    part[2] = 0;
  }
  if (const int within = leading % kWordBits; within != 0) {
    part[0] = part[0] << within | part[1] >> (kWordBits - within);
    part[1] = part[1] << within | part[2] >> (kWordBits - within);
  }
  constexpr std::uint64_t kBelowDouble = 0x7ff;
  const double scale = std::ldexp(is_above_half ? -1.0 : 1.0, -kWordBits - leading);
  const double high = scale * static_cast<double>(part[0] & ~kBelowDouble);
  const double low = scale * (static_cast<double>(part[0] & kBelowDouble) + 0x1p-64 * static_cast<double>(part[1]));
  constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;
  const double rest = high * kHalfPi;
  const double lost = std::fma(high, kHalfPi, -rest) + (high * kHalfPiLow + low * kHalfPi);
  if (angle < 0.0) return {-count & 3, -rest, -lost};
  return {count & 3, rest, lost};
}

}  // namespace firstlight::render
