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
#include <bit>
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
  HWY_INLINE ExactRay(const RayBlock& rays, const Columns3<double>& inverse, std::size_t i)
      : min_depth_(rays.min_depth[i]) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin_[axis] = rays.origin.of[axis][i];
      inverse_[axis] = inverse.of[axis][i];
      near_row_[axis] = 2 * static_cast<int>(axis) + (inverse_[axis] < 0.0 ? 1 : 0);
    }
  }

  /// One over a direction. Zero counts as almost zero: the products below stay numbers, and a ray in the plane of a
  /// face is decided by which side of the face it lies on.
  template <class D, class V>
  static HWY_INLINE V inverse_of(D d, V direction) {
    const auto almost_zero = hn::Set(d, 1e-300);
    const auto small = hn::Lt(hn::Abs(direction), almost_zero);
    return hn::Div(hn::Set(d, 1.0), hn::IfThenElse(small, hn::CopySign(almost_zero, direction), direction));
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

  /// Bits of the slots that the ray meets between its min_depth and `last`.
  HWY_INLINE unsigned meet_children(const WideNode& node, double last) const {
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
    }
    return bits;
  }

  static constexpr double kAway = 1.0 + 2e-15;
  static constexpr double kEndless = 1e308;

 private:
  double origin_[3];
  double inverse_[3];
  int near_row_[3];  ///< row of WideNode::bounds where the ray enters, by axis; the other row of the pair is the exit
  double min_depth_;
};

/// Rays prepared for box tests in float: of the tree as a whole and of children, to find what to visit. A ray meets
/// every child that holds a leaf met by ExactRay, and never enters it later than that leaf.
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
struct FloatRays {
  Columns3<double> exact_inverse;  ///< of ExactRay
  Columns3<float> inverse;
  Columns3<float> enter;             ///< what the depths of faces begin with, less the margin
  Columns3<float> leave;             ///< plus the margin
  Columns3<std::uint32_t> near_row;  ///< of an axis' pair in WideNode::bounds, where a ray enters; times kTreeWidth
  Column<float> min_depth;
  Column<float> last;        ///< not below the depth up to which a ray looks; comes down when something is met
  std::uint64_t usable = 0;  ///< not set where the margin is not small beside the boxes of the tree, or a number would
                             ///< leave the range of floats
  std::uint64_t near = 0;    ///< of the usable, those that may meet the tree's box between their depths

  /// Rays whose `last_depth` is not beyond their min_depth are left out.
  HWY_INLINE FloatRays(const RayBlock& rays, const Column<double>& last_depth, const WideTree& tree) {
    const hn::CappedTag<double, 8> d;
    for (std::size_t i = 0; i < rays.size; i += hn::Lanes(d)) prepare(rays, last_depth, tree, i);
    usable &= rays.all();
    near &= usable;
  }

  /// A float not below `depth`.
  static float above(double depth) {
    const auto f = static_cast<float>(depth);
    return f + (std::abs(f) * 0x1p-22f + 1e-30f);
  }

 private:
  static constexpr int kTreeWidthBits = 3;
  static_assert(1 << kTreeWidthBits == kTreeWidth);
  static constexpr float kSteepest = 0x1p-60f;
  static constexpr float kLeastDirection = 0x1p-10f;
  static constexpr float kLargestDirection = 0x1p10f;

  HWY_INLINE void prepare(const RayBlock& rays, const Column<double>& last_depth, const WideTree& tree, std::size_t i) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> f;
    const FloatLimits& limits = tree.float_limits();
    const auto rounded = [&](const Column<double>& column)
                             HWY_ATTR { return hn::DemoteTo(f, hn::Load(d, column.at.data() + i)); };
    const auto outwards = [&](hn::VFromD<decltype(f)> depth) HWY_ATTR {
      return hn::Add(hn::Mul(hn::Abs(depth), hn::Set(f, 0x1p-22f)), hn::Set(f, 1e-30f));
    };
    const auto least_depth = rounded(rays.min_depth);
    const auto end_depth = rounded(last_depth);
    auto first = hn::Sub(least_depth, outwards(least_depth));
    hn::Store(first, f, min_depth.at.data() + i);
    auto end = hn::Add(end_depth, outwards(end_depth));
    hn::Store(end, f, last.at.data() + i);
    auto fits = hn::Eq(first, first);
    auto strong = hn::Lt(first, hn::Neg(hn::Inf(f)));  // none
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto origin = rounded(rays.origin.of[axis]);
      const auto exact_direction = hn::Load(d, rays.direction.of[axis].at.data() + i);
      hn::Store(ExactRay::inverse_of(d, exact_direction), d, exact_inverse.of[axis].at.data() + i);
      const auto direction = hn::DemoteTo(f, exact_direction);
      const auto size = hn::Abs(direction);
      const auto inv = hn::Div(hn::Set(f, 1.0f), hn::CopySign(hn::Max(size, hn::Set(f, kSteepest)), direction));
      const auto at_zero = hn::Mul(origin, inv);
      const auto share = hn::Add(hn::Mul(hn::Abs(origin), hn::Set(f, 0x1p-20f)), hn::Set(f, limits.shared_margin));
      const auto margin = hn::Mul(share, hn::Abs(inv));
      const auto enter_at = hn::Neg(hn::Add(at_zero, margin));
      const auto leave_at = hn::Sub(margin, at_zero);
      hn::Store(inv, f, inverse.of[axis].at.data() + i);
      const hn::RebindToUnsigned<decltype(f)> u;
      const auto downwards = hn::ShiftRight<31>(hn::BitCast(u, inv));
      hn::Store(hn::ShiftLeft<kTreeWidthBits>(downwards), u, near_row.of[axis].at.data() + i);
      hn::Store(enter_at, f, enter.of[axis].at.data() + i);
      hn::Store(leave_at, f, leave.of[axis].at.data() + i);
      fits = hn::And(fits, hn::And(hn::Lt(hn::Abs(origin), hn::Set(f, limits.farthest_origin)),
                                   hn::Lt(size, hn::Set(f, kLargestDirection))));
      strong = hn::Or(strong, hn::Gt(size, hn::Set(f, kLeastDirection)));
      const auto low = hn::Mul(hn::Set(f, tree.bounds().low[axis]), inv);
      const auto high = hn::Mul(hn::Set(f, tree.bounds().high[axis]), inv);
      first = hn::Max(first, hn::Add(hn::Min(low, high), enter_at));
      end = hn::Min(end, hn::Add(hn::Max(low, high), leave_at));
    }
    usable |= std::uint64_t{bits_of(f, hn::And(fits, strong))} << i;
    near |= std::uint64_t{bits_of(f, hn::Le(first, end))} << i;
  }
};

/// Which of the children from `slot` on a ray may meet between its min_depth and its last.
HWY_INLINE auto meet_children(const WideNode& node, std::size_t slot, const FloatRays& rays, std::size_t ray) {
  const hn::CappedTag<float, kTreeWidth> d;
  auto enter = hn::Set(d, rays.min_depth[ray]);
  auto leave = hn::Set(d, rays.last[ray]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* faces = node.bounds[2 * axis] + slot;
    const std::size_t near = rays.near_row.of[axis][ray];
    const auto inverse = hn::Set(d, rays.inverse.of[axis][ray]);
    enter = hn::Max(enter, hn::MulAdd(hn::Load(d, faces + near), inverse, hn::Set(d, rays.enter.of[axis][ray])));
    leave = hn::Min(
        leave, hn::MulAdd(hn::Load(d, faces + (near ^ kTreeWidth)), inverse, hn::Set(d, rays.leave.of[axis][ray])));
  }
  return hn::Le(enter, leave);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
