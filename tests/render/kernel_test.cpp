// Kernels over lanes have the same bits at every width, whatever stands in the other lanes.
#include "tests/render/kernels.h"

#include "tests/render/each_target.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace firstlight::render {
namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

TEST(Kernels, HaveTheSameBitsAtEveryWidth) {
#ifdef FIRSTLIGHT_SANITIZED
  constexpr int kBlocks = 2;  // everything takes many times as long
#else
  constexpr int kBlocks = 6;
#endif
  const KernelList list;
  for (const Kernel& kernel : list.kernels()) {
    for (int block = 0; block < kBlocks; ++block) {
      const Columns3<double> at = kernel_points(block);
      Columns3<double> first;
      bool is_first = true;
      for_each_target([&](const std::string& target) {
        Columns3<double> results;
        kernel.run(at, kRaysAtOnce, results);
        if (is_first) first = results;
        is_first = false;
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          for (const std::size_t axis : {0, 1, 2}) {
            EXPECT_TRUE(same(results.of[axis][i], first.of[axis][i]))
                << kernel.name << " at " << at.vector(i) << ", " << target << ": " << results.of[axis][i]
                << " instead of " << first.of[axis][i];
          }
        }
      });
    }
  }
}

/// A block's number of points, and where a point stands in it, do not matter.
TEST(Kernels, GiveAPointTheSameAloneAndInABlock) {
  const KernelList list;
  for (const Kernel& kernel : list.kernels()) {
    const Columns3<double> at = kernel_points(1);
    Columns3<double> together;
    kernel.run(at, kRaysAtOnce, together);
    for (const std::size_t i : {0, 5, 17, 63}) {
      Columns3<double> one, alone;
      for (std::size_t k = 0; k < kRaysAtOnce; ++k) one.set(k, Vec3(std::nan("")));
      one.set(0, at.vector(i));
      kernel.run(one, 1, alone);
      for (const std::size_t axis : {0, 1, 2}) {
        EXPECT_TRUE(same(together.of[axis][i], alone.of[axis][0])) << kernel.name << " at " << at.vector(i);
      }
    }
  }
}

}  // namespace
}  // namespace firstlight::render
