#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Whether something holds for the one lane of One.
struct OneMask {
  bool holds;

  friend OneMask operator&(OneMask a, OneMask b) { return {a.holds && b.holds}; }
  friend OneMask operator|(OneMask a, OneMask b) { return {a.holds || b.holds}; }
  friend OneMask operator!(OneMask a) { return {!a.holds}; }
  /// a, but not b.
  friend OneMask without(OneMask a, OneMask b) { return {a.holds && !b.holds}; }
  friend bool any(OneMask a) { return a.holds; }
  friend bool all(OneMask a) { return a.holds; }
  friend unsigned bits(OneMask a) { return a.holds ? 1u : 0u; }
};

/// A double that speaks as Lanes do (render/lanes/lanes-inl.h): what is written over a lane type works on a single number
/// with it, and has the same bits there. Unlike Lanes it belongs to no instruction set.
struct One {
  using Mask = OneMask;
  static constexpr std::size_t kCount = 1;

  double v;

  One() = default;
  One(double value) : v(value) {}  // numbers of a formula stand beside its lanes

  static One load(const double* from) { return *from; }
  static OneMask first(std::size_t count) { return {count >= 1}; }
  static OneMask mask_of(unsigned bits) { return {(bits & 1u) != 0}; }
  void store(double* to) const { *to = v; }

  friend One operator+(One a, One b) { return a.v + b.v; }
  friend One operator-(One a, One b) { return a.v - b.v; }
  friend One operator*(One a, One b) { return a.v * b.v; }
  friend One operator/(One a, One b) { return a.v / b.v; }
  friend One operator-(One a) { return -a.v; }
  friend OneMask operator<(One a, One b) { return {a.v < b.v}; }
  friend OneMask operator<=(One a, One b) { return {a.v <= b.v}; }
  friend OneMask operator>(One a, One b) { return {a.v > b.v}; }
  friend OneMask operator>=(One a, One b) { return {a.v >= b.v}; }
  friend OneMask operator==(One a, One b) { return {a.v == b.v}; }
  friend OneMask operator!=(One a, One b) { return {a.v != b.v}; }
  friend One sqrt(One a) { return std::sqrt(a.v); }
  friend One abs(One a) { return std::abs(a.v); }
  friend One floor(One a) { return std::floor(a.v); }
  friend One trunc(One a) { return std::trunc(a.v); }
  friend One copysign(One size, One sign) { return std::copysign(size.v, sign.v); }
  friend One min(One a, One b) { return b.v < a.v ? b : a; }
  friend One max(One a, One b) { return a.v < b.v ? b : a; }
};

inline One select(OneMask which, One a, One b) { return which.holds ? a : b; }

/// columns[k] is table[*first + k].
inline void load_rows(const double* table, const std::int32_t* first, One (&columns)[4]) {
  for (std::size_t k = 0; k < 4; ++k) columns[k] = table[static_cast<std::size_t>(*first) + k];
}

// The bits of doubles, for what is built on them.

inline void store_bits(One a, std::int64_t* to) { *to = std::bit_cast<std::int64_t>(a.v); }
inline One add_to_bits(One a, std::int64_t amount) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(a.v) + amount);
}
inline One add_bits(One a, One b) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(a.v) + std::bit_cast<std::int64_t>(b.v));
}
inline One and_bits(One a, std::int64_t mask) { return std::bit_cast<double>(std::bit_cast<std::int64_t>(a.v) & mask); }
inline One or_bits(One a, std::int64_t mask) { return std::bit_cast<double>(std::bit_cast<std::int64_t>(a.v) | mask); }
inline One xor_bits(One a, One b) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(a.v) ^ std::bit_cast<std::int64_t>(b.v));
}
template <int kBy>
One shift_bits_left(One a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a.v) << kBy);
}
template <int kBy>
One shift_bits_right(One a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a.v) >> kBy);
}

}  // namespace firstlight::render
