#include "render/math/columns.h"
#include "render/math/vec.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/lanes_test.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Every operation on a[i], b[i], c[i]; results one after the other, 64 of each.
template <class L>
void all_operations(const Column<double>& a, const Column<double>& b, const Column<double>& c,
                    std::vector<Column<double>>& results) {
  std::size_t next = 0;
  const auto put = [&](const L& value, std::size_t i) HWY_ATTR {
    if (next == results.size()) results.emplace_back();
    store(value, results[next++], i);
  };
  for (std::size_t i = 0; i < kRaysAtOnce; i += L::kCount) {
    next = 0;
    const L x = load<L>(a, i), y = load<L>(b, i), z = load<L>(c, i);
    const Vec3Of<L> v{x, y, z}, w{z, x, y};
    for (const L& value : {x + y,
                           x - y,
                           x * y,
                           x / y,
                           -x,
                           x * y + z,
                           sqrt(x),
                           abs(x),
                           floor(x),
                           trunc(x),
                           min(x, y),
                           max(x, y),
                           copysign(x, y),
                           clamp(x, -1.0, 1.0),
                           dot(v, w),
                           cross(v, w).y,
                           length(v),
                           (v * 2.0 - w / y + everywhere<L>(Vec3(1.0, 2.0, 3.0))).z,
                           add_to_bits(x, 1),
                           and_bits(x, ~0xffffll),
                           or_bits(x, 1),
                           add_bits(x, y),
                           shift_bits_left<1>(x),
                           shift_bits_right<12>(x)}) {
      put(value, i);
    }
    for (const MaskOf<L>&mask : {x<y, x <= y, x> y, x >= y, x == y, x != y, (x < y) & (y < z), (x < y) | (y < z),
                                 !(x < y), without(x < y, y < z), L::first(i < 61 ? 61 - i : 0),
                                 L::mask_of(static_cast<unsigned>(std::uint64_t{0xa5c3f00f12345678} >> i))}) {
      put(select(mask, x, z), i);
      put(select(L::mask_of(bits(mask)), L(1.0), L(0.0)), i);
      put(select(mask, v, w).y, i);
      put(one_by_one(mask, x, [](double number) { return number + 1.0; }), i);
    }
  }
}

void all_operations_in_lanes(const Column<double>& a, const Column<double>& b, const Column<double>& c,
                             std::vector<Column<double>>& results) {
  all_operations<Lanes>(a, b, c, results);
}
void all_operations_of_one(const Column<double>& a, const Column<double>& b, const Column<double>& c,
                           std::vector<Column<double>>& results) {
  all_operations<One>(a, b, c, results);
}
std::size_t lane_count() {
  // any and all over as many lanes as there are.
  const LanesMask none = Lanes::first(0), every = Lanes::first(100), some = Lanes::first(1);
  const bool right = !any(none) && any(some) && all(every) && all(some) == (Lanes::kCount == 1);
  return right && bits(every) + 1 == 1u << Lanes::kCount ? Lanes::kCount : 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "tests/render/each_target.h"

namespace firstlight::render {
namespace {

HWY_EXPORT(all_operations_in_lanes);
HWY_EXPORT(lane_count);

const double kSpecial[] = {0.0,
                           -0.0,
                           1.0,
                           -1.0,
                           0.5,
                           -0.5,
                           2.5,
                           -2.5,
                           1e-310,
                           -1e-310,
                           1e300,
                           -1e300,
                           4503599627370497.5,
                           -4503599627370495.5,
                           9007199254740993.0,
                           std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()};

/// Whether they are the same to the bit, or both no numbers: which of two of those a sum keeps is the machine's to choose.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

TEST(Lanes, EveryOperationHasTheBitsOfOne) {
  constexpr std::size_t kCount = std::size(kSpecial);
  std::size_t next = 0;
  for (int block = 0; block < 40; ++block) {
    Column<double> a, b, c;
    for (std::size_t i = 0; i < kRaysAtOnce; ++i, ++next) {
      a[i] = kSpecial[next % kCount];
      b[i] = kSpecial[next / kCount % kCount];
      c[i] = std::sin(static_cast<double>(next)) * 3.0;
    }
    std::vector<Column<double>> expected;
    HWY_STATIC_DISPATCH(all_operations_of_one)(a, b, c, expected);
    for_each_target([&](const std::string& target) {
      std::vector<Column<double>> found;
      HWY_DYNAMIC_DISPATCH(all_operations_in_lanes)(a, b, c, found);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          EXPECT_TRUE(same(found[k][i], expected[k][i]))
              << target << ", operation " << k << " of " << a[i] << ", " << b[i] << ", " << c[i] << ": " << found[k][i]
              << " instead of " << expected[k][i];
        }
      }
    });
  }
}

TEST(Lanes, MasksKnowAllOfTheirLanes) {
  for_each_target([&](const std::string& target) {
    const std::size_t count = HWY_DYNAMIC_DISPATCH(lane_count)();
    EXPECT_TRUE(count == 1 || count == 2 || count == 4 || count == 8) << target << ": " << count;
  });
}

}  // namespace
}  // namespace firstlight::render
#endif
