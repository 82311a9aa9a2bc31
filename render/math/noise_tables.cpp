#include "render/math/noise_tables.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace firstlight::render {
namespace {

/// The random numbers that POV-Ray makes its tables of: 15 bits of each state.
class TableRandom {
 public:
  explicit TableRandom(std::uint32_t seed) : state_(seed) {}
  unsigned next() {
    state_ = state_ * 1812433253u + 12345u;
    return (state_ >> 16) & 0x7fff;
  }

 private:
  std::uint32_t state_;
};

/// The checksum (CRC-16, polynomial 0x8005) over three doubles of 0.12345 * i, highest byte first, brought to -1 to 1
/// and written with six digits. [R. Skinner's noise in the MTV ray tracer, whose table POV-Ray keeps]
double coefficient(double i) {
  const auto bits = std::bit_cast<std::uint64_t>(i * 0.12345);
  unsigned sum = 0;
  for (unsigned byte = 0; byte < 24; ++byte) {
    sum ^= static_cast<unsigned>(bits >> (56 - 8 * (byte % 8))) & 0xff;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? (sum >> 1) ^ 0xa001 : sum >> 1;
  }
  std::array<char, 32> text{};
  const double exact = sum * 2.0 / 65535.0 - 1.0;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), exact, std::chars_format::general, 6).ptr;
  double rounded = 0.0;
  std::from_chars(text.data(), end, rounded);
  return rounded;
}

std::array<double, 4> direction(TableRandom& random) {
  constexpr unsigned kSize = GradientTables::kSize;
  for (;;) {
    std::array<double, 4> v{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] = (static_cast<int>(random.next() % (2 * kSize)) - static_cast<int>(kSize)) / double{kSize};
    }
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (square > 1.0 || square < 1e-5) continue;
    for (double& part : v) part *= 1.0 / std::sqrt(square);
    return v;
  }
}

}  // namespace

LatticeTables::LatticeTables() {
  for (unsigned i = 0; i < kPoints; ++i) permutation[i] = static_cast<std::uint16_t>(i);
  TableRandom random(0);
  for (unsigned i = kPoints; i-- > 0;) std::swap(permutation[i], permutation[random.next() % kPoints]);
  std::copy_n(permutation.begin(), kPoints, permutation.begin() + kPoints);
  for (unsigned i = 0; i < 2 * kPoints; ++i) entry[i] = static_cast<std::uint8_t>(permutation[i] & 0xffu);
  for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients[i] = coefficient(static_cast<double>(i));
}

const LatticeTables& LatticeTables::get() {
  static const LatticeTables tables;
  return tables;
}

GradientTables::GradientTables() {
  TableRandom random(1);
  for (unsigned i = 0; i < kSize; ++i) gradients[i] = direction(random);
  for (unsigned i = 0; i < kSize; ++i) permutation[i] = static_cast<std::uint16_t>(i);
  // Every second entry is exchanged, beginning with the one behind the last, which is 0.
  for (unsigned i = kSize; i > 0; i -= 2) std::swap(permutation[i], permutation[random.next() % kSize]);
  for (unsigned i = 0; i < kSize + 2; ++i) {
    permutation[kSize + i] = permutation[i];
    gradients[kSize + i] = gradients[i];
  }
}

const GradientTables& GradientTables::get() {
  static const GradientTables tables;
  return tables;
}

}  // namespace firstlight::render
