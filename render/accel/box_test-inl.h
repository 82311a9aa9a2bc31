// How a ray meets the boxes of a node, and the box of one leaf. Included once for each instruction set, so the guard
// switches back and forth.
#if defined(FIRSTLIGHT_RENDER_ACCEL_BOX_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_ACCEL_BOX_TEST_INL_H
#undef FIRSTLIGHT_RENDER_ACCEL_BOX_TEST_INL_H
#else
#define FIRSTLIGHT_RENDER_ACCEL_BOX_TEST_INL_H
#endif

#include "render/accel/leaves.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One bit for each lane of `mask`, from bit 0 on. At most eight lanes.
template <class D, class M>
HWY_INLINE unsigned bits_of(D d, M mask) {
  std::uint8_t byte[8] = {};
  hn::StoreMaskBits(d, mask, byte);
  return byte[0];
}

/// A ray prepared for box tests in double. It decides which leaf is met, and where, on every machine alike.
///
/// A slab's depth (face - origin) / direction is computed with three roundings; the exit is moved away by more than
/// twice that, so no box that the exact ray meets is missed. [Ize, Robust BVH Ray Traversal, 2013]
/// Each operation is monotone: a box within another is never entered before it, nor left after it.
class ExactRay {
 public:
  using Depth = double;

  explicit ExactRay(const RayQuery& query) : min_depth_(query.min_depth) {
    // A direction of zero becomes one of almost zero: the products below stay numbers, and a ray in the plane of a
    // face is decided by which side of the face it lies on.
    constexpr double kAlmostZero = 1e-300;
    for (int axis = 0; axis < 3; ++axis) {
      double d = query.ray.direction[axis];
      if (std::abs(d) < kAlmostZero) d = std::copysign(kAlmostZero, d);
      origin_[axis] = query.ray.origin[axis];
      inverse_[axis] = 1.0 / d;
      near_row_[axis] = 2 * axis + (d < 0.0 ? 1 : 0);
    }
  }

  /// Whether the ray meets `box` beyond its min_depth; `near` gets where.
  bool meets(const FloatBox& box, double& near) const {
    near = min_depth_;
    double leave = kEndless;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upwards = near_row_[axis] == 2 * axis;
      const double near_face = upwards ? box.low[axis] : box.high[axis];
      const double far_face = upwards ? box.high[axis] : box.low[axis];
      near = std::max(near, (near_face - origin_[axis]) * inverse_[axis]);
      leave = std::min(leave, (far_face - origin_[axis]) * inverse_[axis]);
    }
    return near <= leave * kAway;
  }

  /// Bits of the slots that the ray meets between its min_depth and `last`; `near` gets where it enters them.
  HWY_INLINE unsigned meet_children(const WideNode& node, double last, double* HWY_RESTRICT near) const {
    const hn::CappedTag<double, kTreeWidth> wide;
    const hn::Rebind<float, decltype(wide)> narrow;
    unsigned bits = 0;
    for (std::size_t slot = 0; slot < kTreeWidth; slot += hn::Lanes(wide)) {
      auto enter = hn::Set(wide, min_depth_);
      auto leave = hn::Set(wide, kEndless);
      for (int axis = 0; axis < 3; ++axis) {
        const auto origin = hn::Set(wide, origin_[axis]);
        const auto inverse = hn::Set(wide, inverse_[axis]);
        const int row = near_row_[axis];
        const auto near_face = hn::PromoteTo(wide, hn::Load(narrow, node.bounds[row] + slot));
        const auto far_face = hn::PromoteTo(wide, hn::Load(narrow, node.bounds[row ^ 1] + slot));
        enter = hn::Max(enter, hn::Mul(hn::Sub(near_face, origin), inverse));
        leave = hn::Min(leave, hn::Mul(hn::Sub(far_face, origin), inverse));
      }
      leave = hn::Min(hn::Mul(leave, hn::Set(wide, kAway)), hn::Set(wide, last));
      bits |= bits_of(wide, hn::Le(enter, leave)) << slot;
      hn::Store(enter, wide, near + slot);
    }
    return bits;
  }

  static double above(double depth) { return depth; }

 private:
  static constexpr double kAway = 1.0 + 2e-15;
  static constexpr double kEndless = 1e308;

  double origin_[3];
  double inverse_[3];
  int near_row_[3];  ///< row of WideNode::bounds where the ray enters, by axis; the other row of the pair is the exit
  double min_depth_;
};

/// A ray prepared for box tests in float: of children only, to find what to visit. It meets every child that holds a
/// leaf met by ExactRay, and never enters it later than that leaf.
///
/// With u = 2^-24, o the origin, n a face, i the inverse direction, all in float and of one axis, the depth n i - o i
/// is off by at most |i| u (|o| + 2 (|n| + |o|) + |o| + |o| + 2 |n| + |o|), in turn: o, i with its direction, the
/// product o i, its sum with the margin, the product n i (no matter if fused), the sum; less than |i| (2^-21 |o| +
/// 2^-22 |n|). Twice that is given: 2^-20 |o| in the margin, 2^-21 |n| in the faces themselves (WideNode::kFaceRoom).
/// ExactRay's own rounding, 2^-49 (|o| + |n|), is far within.
///
/// Directions below kSteepest are taken for that. The largest is above kLeastDirection, so inside of the tree's boxes
/// the depth is at most (|o| + reach) / kLeastDirection, and the ray moves by less than 2^-48 (|o| + reach), the other
/// part of the margin (FloatLimits::shared_margin).
class FloatRay {
 public:
  using Depth = float;

  FloatRay(const RayQuery& query, const FloatLimits& limits) : min_depth_(-above(-query.min_depth)) {
    const hn::CappedTag<float, 4> d;
    alignas(32) float origins[4];
    alignas(32) float directions[4];
    to_float(query, 0, origins);
    to_float(query, 3, directions);
    unsigned near_bits = 0;
    unsigned close = 0;
    unsigned gentle = 0;
    unsigned strong = 0;
    for (std::size_t axis = 0; axis < 4; axis += hn::Lanes(d)) {
      const auto origin = hn::Load(d, origins + axis);
      const auto direction = hn::Load(d, directions + axis);
      const auto size = hn::Abs(direction);
      const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::CopySign(hn::Max(size, hn::Set(d, kSteepest)), direction));
      const auto at_zero = hn::Mul(origin, inverse);
      const auto share = hn::Add(hn::Mul(hn::Abs(origin), hn::Set(d, 0x1p-20f)), hn::Set(d, limits.shared_margin));
      const auto margin = hn::Mul(share, hn::Abs(inverse));
      hn::Store(inverse, d, inverse_ + axis);
      hn::Store(hn::Neg(hn::Add(at_zero, margin)), d, enter_ + axis);
      hn::Store(hn::Sub(margin, at_zero), d, leave_ + axis);
      near_bits |= bits_of(d, hn::Lt(inverse, hn::Zero(d))) << axis;
      close |= bits_of(d, hn::Lt(hn::Abs(origin), hn::Set(d, limits.farthest_origin))) << axis;
      gentle |= bits_of(d, hn::Lt(size, hn::Set(d, kLargestDirection))) << axis;
      strong |= bits_of(d, hn::Gt(size, hn::Set(d, kLeastDirection))) << axis;
    }
    for (unsigned axis = 0; axis < 3; ++axis) near_row_[axis] = 2 * axis + (near_bits >> axis & 1u);
    usable_ = (close & gentle & 7u) == 7u && (strong & 7u) != 0;
  }

  /// False where the margin is not small beside the boxes of the tree, or a number would leave the range of floats.
  bool usable() const { return usable_; }

  /// Bits of the slots that the ray may meet between its min_depth and `last`; `near` gets where it may enter them.
  HWY_INLINE unsigned meet_children(const WideNode& node, float last, float* HWY_RESTRICT near) const {
    const hn::CappedTag<float, kTreeWidth> wide;
    unsigned bits = 0;
    for (std::size_t slot = 0; slot < kTreeWidth; slot += hn::Lanes(wide)) {
      auto enter = hn::Set(wide, min_depth_);
      auto leave = hn::Set(wide, last);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto inverse = hn::Set(wide, inverse_[axis]);
        const std::size_t row = near_row_[axis];
        const auto near_face = hn::Load(wide, node.bounds[row] + slot);
        const auto far_face = hn::Load(wide, node.bounds[row ^ 1] + slot);
        enter = hn::Max(enter, hn::MulAdd(near_face, inverse, hn::Set(wide, enter_[axis])));
        leave = hn::Min(leave, hn::MulAdd(far_face, inverse, hn::Set(wide, leave_[axis])));
      }
      bits |= bits_of(wide, hn::Le(enter, leave)) << slot;
      hn::Store(enter, wide, near + slot);
    }
    return bits;
  }

  /// A float not below `depth`.
  static float above(double depth) {
    const auto f = static_cast<float>(depth);
    return f + (std::abs(f) * 0x1p-22f + 1e-30f);
  }

 private:
  static constexpr float kSteepest = 0x1p-60f;
  static constexpr float kLeastDirection = 0x1p-10f;
  static constexpr float kLargestDirection = 0x1p10f;

  /// Four numbers of the query from the one at `first` on: three of a vector, and a fourth that nobody reads.
  static HWY_INLINE void to_float(const RayQuery& query, std::size_t first, float* HWY_RESTRICT out) {
    static_assert(offsetof(RayQuery, min_depth) == 6 * sizeof(double), "origin, direction, min_depth in a row");
    const hn::CappedTag<double, 4> d;
    const hn::Rebind<float, decltype(d)> f;
    const double* numbers = &query.ray.origin.x + first;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) hn::Store(hn::DemoteTo(f, hn::LoadU(d, numbers + i)), f, out + i);
  }

  alignas(32) float inverse_[4];
  alignas(32) float enter_[4];  ///< what the depths of faces begin with, less the margin
  alignas(32) float leave_[4];  ///< plus the margin
  std::size_t near_row_[3];
  float min_depth_;
  bool usable_;
};

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
