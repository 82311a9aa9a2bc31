// Blocks of rays meet shapes and combinations as single rays do, to the bit, at every width.
#include "tests/render/each_target.h"
#include "tests/render/kernels.h"
#include "tests/render/shape_list.h"
#include "tests/render/solid_test_support.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

namespace firstlight::render {
namespace {

using Kind = Solid::Kind;

#ifdef FIRSTLIGHT_SANITIZED
constexpr int kBlocks = 1, kRounds = 30;
#else
constexpr int kBlocks = 9, kRounds = 400;
#endif
constexpr std::uint64_t kSome = 0xfff0f731'3a50ffffu;

std::vector<RayColumns> blocks_of_rays() {
  std::vector<RayColumns> blocks;
  for (int block = 0; block < kBlocks; ++block) blocks.push_back(rays_from(kernel_points(block), kRaysAtOnce));
  return blocks;
}

TEST(ShapeBlocks, HaveTheCrossingsOfSingleRays) {
  const std::vector<NamedShape> shapes = shapes_and_julia_sets();
  const std::vector<RayColumns> blocks = blocks_of_rays();
  std::size_t met = 0;
  for_each_target([&](const std::string& target) {
    for (const NamedShape& named : shapes) {
      SCOPED_TRACE(named.name + ", " + target);
      for (const RayColumns& rays : blocks) {
        Slots& slots = Slots::of_thread();
        named.shape->meet_block(rays, kSome, nullptr, slots);
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          const std::uint64_t bit = std::uint64_t{1} << i;
          std::vector<Crossing> alone;
          if ((kSome & bit) != 0) named.shape->crossings(rays.ray(i), alone);
          std::size_t c = 0;
          for (std::size_t s = 0; s < slots.size(); ++s) {
            if ((slots[s].rays & bit) == 0) continue;
            ASSERT_LT(c, alone.size());
            EXPECT_EQ(slots[s].depth[i], alone[c].depth);
            EXPECT_EQ(slots[s].face_of(i), alone[c].face);
            EXPECT_EQ(slots[s].place_of(i), alone[c].place);
            EXPECT_EQ(slots[s].shape, alone[c].shape);
            ++c;
          }
          EXPECT_EQ(c, alone.size());
          met += c;
        }
      }
    }
  });
  EXPECT_GT(met, 400u * kBlocks);
}

TEST(ShapeBlocks, HaveTheNearestCrossingsOfSingleRays) {
  const std::vector<NamedShape> shapes = shapes_of_all_kinds();
  const std::vector<RayColumns> blocks = blocks_of_rays();
  std::size_t met = 0;
  for_each_target([&](const std::string& target) {
    for (const NamedShape& named : shapes) {
      SCOPED_TRACE(named.name + ", " + target);
      for (const RayColumns& rays : blocks) {
        Column<double> low;
        Column<double> high;
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          low[i] = 0.05 * static_cast<double>(i % 40);
          high[i] = low[i] + (i % 3 == 0 ? 1.0 : 50.0);
        }
        const DepthWindow window{low, high};
        Slots& slots = Slots::of_thread();
        named.shape->meet_block(rays, kSome, &window, slots);
        NearestCrossings nearest;
        SlotSearch(slots, 0).find(kSome, window, nearest);
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          std::vector<Crossing> alone;
          if ((kSome >> i & 1) != 0) named.shape->nearest(rays.ray(i), low[i], high[i], alone);
          std::optional<double> depth;
          for (const Crossing& crossing : alone) {
            const bool counts = crossing.depth > low[i] && crossing.depth <= high[i];
            if (counts && (!depth || crossing.depth < *depth)) depth = crossing.depth;
          }
          ASSERT_EQ((nearest.rays >> i & 1) != 0, depth.has_value());
          if (!depth) continue;
          EXPECT_EQ(nearest.depth[i], *depth);
          ++met;
        }
      }
    }
  });
  EXPECT_GT(met, 400u * kBlocks);
}

TEST(ShapeBlocks, HoldThePointsThatTheyHoldAlone) {
  const std::vector<NamedShape> shapes = shapes_and_julia_sets();
  for_each_target([&](const std::string& target) {
    for (const NamedShape& named : shapes) {
      for (int block = 0; block < kBlocks; ++block) {
        const Columns3<double> points = kernel_points(block);
        const std::uint64_t held = named.shape->inside_block(points, kSome);
        for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
          const bool holds = (kSome >> i & 1) != 0 && named.shape->inside(points.vector(i));
          EXPECT_EQ((held >> i & 1) != 0, holds) << named.name << ", " << target << ", " << points.vector(i);
        }
      }
    }
  });
}

/// A combination of up to `levels` levels, with clips, bounds and members that hide from some rays.
class SolidMaker {
 public:
  explicit SolidMaker(unsigned seed) : dice_(seed), shapes_(shapes_of_all_kinds()) {}

  Solid make(int levels) {
    if (levels == 0 || dice_() % 4 == 0) return some_shape();
    constexpr Kind kKinds[] = {Kind::union_, Kind::intersection, Kind::merge};
    std::vector<Solid> members;
    const std::size_t count = dice_() % 12 == 0 ? 15 : 1 + dice_() % 4;
    for (std::size_t i = 0; i < count; ++i) members.push_back(make(levels - 1));
    for (Solid& member : members) {
      if (dice_() % 8 == 0) member.hidden_from = static_cast<std::uint8_t>(1 + dice_() % 7);
    }
    Solid solid;
    solid.kind = kKinds[dice_() % 3];
    solid.set_members(std::move(members));
    cut(solid);
    solid.close();
    return solid;
  }

 private:
  Solid some_shape() {
    Solid solid;
    const Vec3 away(0.1 * static_cast<double>(dice_() % 9), 0.0, 0.1 * static_cast<double>(dice_() % 5));
    solid.shape = shapes_[dice_() % shapes_.size()].shape->placed(Transform::translation(away));
    solid.part = static_cast<std::uint32_t>(dice_() % 8);
    if (dice_() % 6 == 0) cut(solid);
    solid.close();
    return solid;
  }
  void cut(Solid& solid) {
    if (dice_() % 5 == 0) solid.set_clips({make(1)});
    if (dice_() % 5 == 0) solid.set_bounds({make(1)});
  }

  std::mt19937 dice_;
  std::vector<NamedShape> shapes_;
};

/// The crossing that Solid::meet() is to find for one ray.
std::optional<Crossing> nearest_alone(const Solid& solid, const Ray& ray, std::uint8_t hidden_bit, double low,
                                      double high, const std::vector<bool>* opaque_parts) {
  std::vector<Crossing> all;
  solid.crossings(ray, hidden_bit, all);
  std::optional<Crossing> nearest;
  for (const Crossing& c : all) {
    if (opaque_parts != nullptr && !(*opaque_parts)[c.part]) continue;
    if (c.depth > low && c.depth <= high && (!nearest || c.depth <= nearest->depth)) nearest = c;
  }
  return nearest;
}

TEST(SolidBlocks, FindWhatSingleRaysFind) {
  const std::vector<RayColumns> blocks = blocks_of_rays();
  const std::vector<bool> opaque_parts{true, false, true, true, false, true, false, true};
  constexpr std::uint8_t kBits[] = {0, kHiddenFromPrimary, kHiddenFromReflection, kHiddenFromShadow};
  SolidMaker maker(7);
  std::size_t met = 0;
  for (int round = 0; round < kRounds; ++round) {
    const Solid solid = maker.make(3);
    const RayColumns& rays = blocks[static_cast<std::size_t>(round) % blocks.size()];
    const std::uint8_t hidden_bit = kBits[round / 3 % 4];
    const auto* parts = round % 2 == 0 ? nullptr : &opaque_parts;
    Columns3<double> inverse;
    Column<double> low, high;
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      for (std::size_t axis : {0, 1, 2}) {
        const double d = rays.direction.of[axis][i];
        inverse.of[axis][i] = d == 0.0 ? 1e300 : 1.0 / d;
      }
      low[i] = i % 3 == 0 ? 0.0 : 0.05 * static_cast<double>(i);
      high[i] = i % 5 == 0 ? 3.0 : 1e7;
    }
    const BlockQuestion question{rays, inverse, DepthWindow{low, high}, parts};
    for_each_target([&](const std::string& target) {
      Slots& slots = Slots::of_thread();
      NearestCrossings nearest;
      ASSERT_TRUE(solid.meet(question, hidden_bit, kSome, slots, nearest));
      const std::uint64_t held = solid.inside(rays.origin, kSome);
      for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
        SCOPED_TRACE(fmt::format("solid {}, ray {}, {}", round, i, target));
        if ((kSome >> i & 1) == 0) {
          EXPECT_EQ((nearest.rays | held) >> i & 1, 0u);
          continue;
        }
        EXPECT_EQ((held >> i & 1) != 0, solid.inside(rays.origin.vector(i)));
        const auto alone = nearest_alone(solid, rays.ray(i), hidden_bit, low[i], high[i], parts);
        ASSERT_EQ((nearest.rays >> i & 1) != 0, alone.has_value());
        if (!alone) continue;
        ++met;
        const Slot& slot = slots[nearest.slot_of(i)];
        EXPECT_EQ(nearest.depth[i], alone->depth);
        EXPECT_EQ(slot.shape, alone->shape);
        EXPECT_EQ(slot.part, alone->part);
        EXPECT_EQ(slot.face_of(i), alone->face);
      }
    });
  }
  EXPECT_GT(met, 10u * kRounds);
}

TEST(SolidBlocks, AreNotMetTogetherWhenTooDeep) {
  Solid solid = solid_of(make_sphere(Vec3(0.0), 1.0), 0);
  for (int level = 0; level < 40; ++level) {
    solid = combined(Kind::intersection, {solid, solid_of(make_sphere(Vec3(0.01 * level, 0.0, 0.0), 1.0), 0)});
  }
  EXPECT_FALSE(solid.suits_blocks());
  EXPECT_TRUE(combined(Kind::intersection, {solid_of(make_torus(1.0, 0.2), 0)}).suits_blocks());
}

TEST(SolidBlocks, GiveUpWhenCrossingsAreTooMany) {
  std::vector<Solid> members;
  for (int i = 0; i < 600; ++i) members.push_back(solid_of(make_sphere(Vec3(3.0 * i, 0.0, 0.0), 1.0), 0));
  const Solid chain = combined(Kind::merge, std::move(members));
  RayColumns rays;
  Columns3<double> inverse;
  Column<double> low, high;
  rays.origin.set(0, Vec3(-5.0, 0.0, 0.0));
  rays.direction.set(0, Vec3(1.0, 0.0, 0.0));
  inverse.set(0, Vec3(1.0, 1e300, 1e300));
  low[0] = 0.0;
  high[0] = 1e7;
  Slots& slots = Slots::of_thread();
  NearestCrossings nearest;
  EXPECT_FALSE(chain.meet({rays, inverse, {low, high}, nullptr}, 0, 1, slots, nearest));
}

}  // namespace
}  // namespace firstlight::render
