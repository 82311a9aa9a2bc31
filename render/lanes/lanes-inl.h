// Numbers side by side, one in each lane of a vector. Included once for each instruction set, so the guard switches back
// and forth.
//
// Arithmetic for points or rays is written once, as a template over a lane type: Lanes here, or One
// (render/lanes/one.h) for a single number. No operation is fused, and sums and products are made in the order in which
// they are written, so a lane has the same bits at every width and on every machine, whatever stands in the other
// lanes.
#if defined(FIRSTLIGHT_RENDER_LANES_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_LANES_LANES_INL_H
#undef FIRSTLIGHT_RENDER_LANES_LANES_INL_H
#else
#define FIRSTLIGHT_RENDER_LANES_LANES_INL_H
#endif

#include "render/lanes/one.h"

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many doubles as a vector holds, at most eight: 2, 4 or 8.
using LaneTag = hn::CappedTag<double, 8>;
using LaneVector = hn::VFromD<LaneTag>;
using LaneVectorMask = decltype(hn::Eq(LaneVector(), LaneVector()));

struct LanesMask {
  LaneVectorMask m;

  friend HWY_INLINE LanesMask operator&(const LanesMask& a, const LanesMask& b) { return {hn::And(a.m, b.m)}; }
  friend HWY_INLINE LanesMask operator|(const LanesMask& a, const LanesMask& b) { return {hn::Or(a.m, b.m)}; }
  friend HWY_INLINE LanesMask operator!(const LanesMask& a) { return {hn::Not(a.m)}; }
  /// a, but not b.
  friend HWY_INLINE LanesMask without(const LanesMask& a, const LanesMask& b) { return {hn::AndNot(b.m, a.m)}; }
  friend HWY_INLINE bool any(const LanesMask& a) { return !hn::AllFalse(LaneTag(), a.m); }
  friend HWY_INLINE bool all(const LanesMask& a) { return hn::AllTrue(LaneTag(), a.m); }
  /// Bit i for lane i.
  friend HWY_INLINE unsigned bits(const LanesMask& a) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(LaneTag(), a.m, bytes);
    return bytes[0];
  }
};

struct Lanes {
  using Mask = LanesMask;
  static constexpr std::size_t kCount = hn::MaxLanes(LaneTag());

  LaneVector v;

  Lanes() = default;
  HWY_INLINE Lanes(const LaneVector& vector) : v(vector) {}
  HWY_INLINE Lanes(double everywhere) : v(hn::Set(LaneTag(), everywhere)) {}

  static HWY_INLINE Lanes load(const double* from) { return hn::LoadU(LaneTag(), from); }
  /// The mask of the lanes below `count`, which may be more than there are.
  static HWY_INLINE LanesMask first(std::size_t count) {
    return {hn::FirstN(LaneTag(), count < kCount ? count : kCount)};
  }
  /// Lane i by bit i; higher bits do not matter.
  static HWY_INLINE LanesMask mask_of(unsigned bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits & ((1u << kCount) - 1u))};
    return {hn::LoadMaskBits(LaneTag(), bytes)};
  }
  HWY_INLINE void store(double* to) const { hn::StoreU(v, LaneTag(), to); }

  friend HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return hn::Add(a.v, b.v); }
  friend HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return hn::Sub(a.v, b.v); }
  friend HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return hn::Mul(a.v, b.v); }
  friend HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return hn::Div(a.v, b.v); }
  friend HWY_INLINE Lanes operator-(const Lanes& a) { return hn::Neg(a.v); }
  friend HWY_INLINE LanesMask operator<(const Lanes& a, const Lanes& b) { return {hn::Lt(a.v, b.v)}; }
  friend HWY_INLINE LanesMask operator<=(const Lanes& a, const Lanes& b) { return {hn::Le(a.v, b.v)}; }
  friend HWY_INLINE LanesMask operator>(const Lanes& a, const Lanes& b) { return {hn::Gt(a.v, b.v)}; }
  friend HWY_INLINE LanesMask operator>=(const Lanes& a, const Lanes& b) { return {hn::Ge(a.v, b.v)}; }
  friend HWY_INLINE LanesMask operator==(const Lanes& a, const Lanes& b) { return {hn::Eq(a.v, b.v)}; }
  friend HWY_INLINE LanesMask operator!=(const Lanes& a, const Lanes& b) { return {hn::Not(hn::Eq(a.v, b.v))}; }
  friend HWY_INLINE Lanes sqrt(const Lanes& a) { return hn::Sqrt(a.v); }
  friend HWY_INLINE Lanes abs(const Lanes& a) { return hn::Abs(a.v); }
  friend HWY_INLINE Lanes copysign(const Lanes& size, const Lanes& sign) { return hn::CopySign(size.v, sign.v); }
#if HWY_TARGET <= HWY_SSE4
  friend HWY_INLINE Lanes floor(const Lanes& a) { return hn::Floor(a.v); }
  friend HWY_INLINE Lanes trunc(const Lanes& a) { return hn::Trunc(a.v); }
#else
  // Where it takes several operations, the sign of 0 is lost on the way.
  friend HWY_INLINE Lanes floor(const Lanes& a) { return hn::CopySign(hn::Floor(a.v), a.v); }
  friend HWY_INLINE Lanes trunc(const Lanes& a) { return hn::CopySign(hn::Trunc(a.v), a.v); }
#endif
  /// As std::min and std::max: a unless b is less (or more), so a too where one is no number.
  friend HWY_INLINE Lanes min(const Lanes& a, const Lanes& b) { return hn::IfThenElse(hn::Lt(b.v, a.v), b.v, a.v); }
  friend HWY_INLINE Lanes max(const Lanes& a, const Lanes& b) { return hn::IfThenElse(hn::Lt(a.v, b.v), b.v, a.v); }
};

/// A bit for each lane.
constexpr std::uint64_t kAllLanes = (std::uint64_t{1} << Lanes::kCount) - 1;

/// a in the lanes of `which`, b in the others.
HWY_INLINE Lanes select(const LanesMask& which, const Lanes& a, const Lanes& b) {
  return hn::IfThenElse(which.m, a.v, b.v);
}

// The bits of doubles, for what is built on them.

using LaneBits = hn::RebindToSigned<LaneTag>;
HWY_INLINE auto bits_of(const Lanes& a) { return hn::BitCast(LaneBits(), a.v); }

HWY_INLINE void store_bits(const Lanes& a, std::int64_t* to) { hn::StoreU(bits_of(a), LaneBits(), to); }
HWY_INLINE Lanes add_to_bits(const Lanes& a, std::int64_t amount) {
  return hn::BitCast(LaneTag(), hn::Add(bits_of(a), hn::Set(LaneBits(), amount)));
}
HWY_INLINE Lanes add_bits(const Lanes& a, const Lanes& b) {
  return hn::BitCast(LaneTag(), hn::Add(bits_of(a), bits_of(b)));
}
HWY_INLINE Lanes and_bits(const Lanes& a, std::int64_t mask) {
  return hn::BitCast(LaneTag(), hn::And(bits_of(a), hn::Set(LaneBits(), mask)));
}
HWY_INLINE Lanes or_bits(const Lanes& a, std::int64_t mask) {
  return hn::BitCast(LaneTag(), hn::Or(bits_of(a), hn::Set(LaneBits(), mask)));
}
HWY_INLINE Lanes xor_bits(const Lanes& a, const Lanes& b) { return hn::Xor(a.v, b.v); }
template <int kBy>
HWY_INLINE Lanes shift_bits_left(const Lanes& a) {
  return hn::BitCast(LaneTag(), hn::ShiftLeft<kBy>(bits_of(a)));
}
template <int kBy>
HWY_INLINE Lanes shift_bits_right(const Lanes& a) {
  return hn::BitCast(LaneTag(), hn::ShiftRight<kBy>(hn::BitCast(hn::RebindToUnsigned<LaneTag>(), a.v)));
}

// ---- Over any lane type ----------------------------------------------------------------------------------------------

template <class L>
using MaskOf = typename L::Mask;

/// A number of a formula beside the lanes: converted, not deduced from.
template <class L>
using Same = std::type_identity_t<L>;

/// Three numbers of each lane. Its functions stand beside it: GCC forgets the instruction set of those that a class template
/// defines within itself.
template <class L>
struct Vec3Of {
  L x, y, z;
};

/// One vector in all lanes.
template <class L, class Vector>
HWY_INLINE Vec3Of<L> everywhere(const Vector& v) {
  return {L(v.x), L(v.y), L(v.z)};
}
template <class L>
HWY_INLINE Vec3Of<L> operator+(const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class L>
HWY_INLINE Vec3Of<L> operator-(const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class L>
HWY_INLINE Vec3Of<L> operator-(const Vec3Of<L>& a) {
  return {-a.x, -a.y, -a.z};
}
/// By components.
template <class L>
HWY_INLINE Vec3Of<L> operator*(const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class L>
HWY_INLINE Vec3Of<L> operator*(const Vec3Of<L>& a, const Same<L>& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class L>
HWY_INLINE Vec3Of<L> operator/(const Vec3Of<L>& a, const Same<L>& s) {
  return {a.x / s, a.y / s, a.z / s};
}
template <class L>
HWY_INLINE L dot(const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class L>
HWY_INLINE Vec3Of<L> cross(const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class L>
HWY_INLINE L length(const Vec3Of<L>& a) {
  return sqrt(dot(a, a));
}
template <class L>
HWY_INLINE Vec3Of<L> select(const MaskOf<L>& which, const Vec3Of<L>& a, const Vec3Of<L>& b) {
  return {select(which, a.x, b.x), select(which, a.y, b.y), select(which, a.z, b.z)};
}

/// The lanes from `i` on of a Column<double>, and the way back.
template <class L, class Column>
HWY_INLINE L load(const Column& column, std::size_t i) {
  return L::load(&column[i]);
}
template <class L, class Column>
HWY_INLINE void store(const L& a, Column& column, std::size_t i) {
  a.store(&column[i]);
}
/// Those of a Columns3<double>.
template <class L, class Columns>
HWY_INLINE Vec3Of<L> load3(const Columns& columns, std::size_t i) {
  return {load<L>(columns.of[0], i), load<L>(columns.of[1], i), load<L>(columns.of[2], i)};
}
template <class L, class Columns>
HWY_INLINE void store3(const Vec3Of<L>& a, Columns& columns, std::size_t i) {
  store(a.x, columns.of[0], i);
  store(a.y, columns.of[1], i);
  store(a.z, columns.of[2], i);
}

/// columns[k] is table[first[i] + k] in lane i: four numbers of the table side by side for each lane.
HWY_INLINE void load_rows(const double* table, const std::int32_t* first, Lanes (&columns)[4]) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t k = 0; k < 4; ++k) columns[k] = Lanes(table[first[0] + static_cast<std::int32_t>(k)]);
#elif HWY_MAX_BYTES == 16
  const LaneTag d;
  const auto a = hn::LoadU(d, table + first[0]), b = hn::LoadU(d, table + first[0] + 2);
  const auto e = hn::LoadU(d, table + first[1]), f = hn::LoadU(d, table + first[1] + 2);
  columns[0] = hn::InterleaveLower(d, a, e);
  columns[1] = hn::InterleaveUpper(d, a, e);
  columns[2] = hn::InterleaveLower(d, b, f);
  columns[3] = hn::InterleaveUpper(d, b, f);
#else
  const LaneTag d;
  LaneVector rows[4];
  for (std::size_t k = 0; k < 4; ++k) {
    if constexpr (Lanes::kCount == 4) {
      rows[k] = hn::LoadU(d, table + first[k]);
    } else {
      const hn::Half<LaneTag> half;
      rows[k] = hn::Combine(d, hn::LoadU(half, table + first[k + 4]), hn::LoadU(half, table + first[k]));
    }
  }
  const auto low01 = hn::InterleaveLower(d, rows[0], rows[1]), high01 = hn::InterleaveUpper(d, rows[0], rows[1]);
  const auto low23 = hn::InterleaveLower(d, rows[2], rows[3]), high23 = hn::InterleaveUpper(d, rows[2], rows[3]);
  columns[0] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(low23), low01);
  columns[1] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(high23), high01);
  columns[2] = hn::OddEvenBlocks(low23, hn::SwapAdjacentBlocks(low01));
  columns[3] = hn::OddEvenBlocks(high23, hn::SwapAdjacentBlocks(high01));
#endif
}

/// Into [low, high]; what is no number stays so.
template <class L>
HWY_INLINE L clamp(const L& a, double low, double high) {
  return select(a < L(low), L(low), select(L(high) < a, L(high), a));
}

/// function(number) in each lane of `which`, one after the other; `a` in the others.
template <class L, class Function>
HWY_INLINE L one_by_one(const MaskOf<L>& which, const L& a, const Function& function) {
  double numbers[L::kCount];
  a.store(numbers);
  const unsigned chosen = bits(which);
  for (std::size_t i = 0; i < L::kCount; ++i) {
    if ((chosen >> i & 1u) != 0) numbers[i] = function(numbers[i]);
  }
  return L::load(numbers);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
