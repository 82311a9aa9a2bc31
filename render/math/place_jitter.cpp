#include "render/math/place_jitter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace firstlight::render {
namespace {

constexpr std::uint32_t kMask = 4095;

// The numbers below 4096 in the order in which POV-Ray's linear congruential generator shuffles them.
constexpr std::array<std::uint16_t, kMask + 1> shuffled_numbers() {
  std::array<std::uint16_t, kMask + 1> numbers{};
  for (std::uint32_t i = 0; i <= kMask; ++i) numbers[i] = static_cast<std::uint16_t>(i);
  std::uint32_t random = 0;
  for (std::uint32_t i = kMask + 1; i-- > 0;) {
    random = random * 1812433253u + 12345u;
    std::swap(numbers[i], numbers[(random >> 16) & kMask]);
  }
  return numbers;
}

// `part` / 65536 with six decimals: far rows of a checkered floor show the difference.
constexpr float six_decimals(std::int64_t part) {
  const std::int64_t size = part < 0 ? -part : part;
  const std::int64_t millionths = (2 * size * 1'000'000 + 65536) / (2 * 65536);
  return static_cast<float>(part < 0 ? -millionths : millionths) / 1e6f;
}

// 256 numbers between -1/2 and 1/2. They are a linear code over bits: entry i is the exclusive or of the entries of its
// bits, each of which is the one before, doubled in the field of 2^16 elements by 0x8006.
constexpr std::array<float, 256> moves() {
  std::array<float, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t sum = 0;
    std::uint32_t entry = 0x8182;
    for (std::uint32_t bits = i; bits != 0; bits >>= 1) {
      if ((bits & 1) != 0) sum ^= entry;
      entry = (entry << 1) ^ ((entry & 0x8000) != 0 ? 0x18006u : 0u);
    }
    table[i] = six_decimals(static_cast<std::int64_t>(sum) - 32768);
  }
  return table;
}

constexpr std::array<std::uint16_t, kMask + 1> kShuffled = shuffled_numbers();
constexpr std::array<float, 256> kMoves = moves();

// Towards zero, also of places left of the picture and above it.
std::uint32_t steps(double place, double a_pixel) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(place * a_pixel));
}

double move_of(std::uint32_t column, std::uint32_t row) {
  return static_cast<double>(kMoves[kShuffled[(kShuffled[column & kMask] ^ row) & kMask] & 255]);
}

}  // namespace

std::uint32_t shuffled(std::uint32_t index) { return kShuffled[index & kMask]; }

PlaceJitter place_jitter(double x, double y) {
  return {move_of(steps(x, 1021.0), steps(y, 1019.0)), move_of(steps(x, 1019.0), steps(y, 1021.0))};
}

}  // namespace firstlight::render
