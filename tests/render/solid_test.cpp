#include "tests/render/solid_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace firstlight::render {
namespace {

using Kind = Solid::Kind;

const Ray kAlongX{Vec3(-10, 0, 0), Vec3(1, 0, 0)};

std::vector<Crossing> all(const Solid& solid, const Ray& ray, std::uint8_t hidden_bit = kHiddenFromPrimary) {
  std::vector<Crossing> out;
  solid.crossings(ray, hidden_bit, out);
  return out;
}

std::vector<double> sorted_depths(const Solid& solid, const Ray& ray, std::uint8_t hidden_bit = kHiddenFromPrimary) {
  std::vector<double> out;
  for (const Crossing& c : all(solid, ray, hidden_bit)) out.push_back(c.depth);
  std::sort(out.begin(), out.end());
  return out;
}

Solid ball(double x, double radius, std::uint32_t part = 0) {
  return solid_of(make_sphere(Vec3(x, 0, 0), radius), part);
}

Solid inverted_ball(double x, double radius, std::uint32_t part = 0) {
  return solid_of(make_sphere(Vec3(x, 0, 0), radius)->inverted(), part);
}

using Depths = std::vector<double>;

TEST(Solid, DifferenceCutsAwayAndShowsTheCut) {
  const Solid bitten = combined(Kind::intersection, {ball(0, 2, 7), inverted_ball(2, 1, 8)});
  EXPECT_EQ(sorted_depths(bitten, kAlongX), (Depths{8.0, 11.0}));
  const std::vector<Crossing> found = all(bitten, kAlongX);
  for (const Crossing& c : found) EXPECT_EQ(c.part, c.depth == 8.0 ? 7u : 8u);
  EXPECT_TRUE(bitten.inside(Vec3(0, 0, 0)));
  EXPECT_FALSE(bitten.inside(Vec3(1.5, 0, 0)));
  EXPECT_FALSE(bitten.inside(Vec3(2.5, 0, 0)));
}

TEST(Solid, IntersectionKeepsWhatLiesInAll) {
  const Solid lens = combined(Kind::intersection, {ball(-1, 2), ball(1, 2)});
  EXPECT_EQ(sorted_depths(lens, kAlongX), (Depths{9.0, 11.0}));
  EXPECT_NEAR(lens.box().min.x, -1.0, 1e-4);
  EXPECT_NEAR(lens.box().max.x, 1.0, 1e-4);
}

TEST(Solid, UnionShowsInnerSurfacesAndMergeDoesNot) {
  EXPECT_EQ(sorted_depths(combined(Kind::union_, {ball(-1, 2), ball(1, 2)}), kAlongX), (Depths{7.0, 9.0, 11.0, 13.0}));
  EXPECT_EQ(sorted_depths(combined(Kind::merge, {ball(-1, 2), ball(1, 2)}), kAlongX), (Depths{7.0, 13.0}));
}

TEST(Solid, ClipsCutTheSurfaceOpen) {
  const Solid bowl = clipped(ball(0, 2), solid_of(make_plane(Vec3(1, 0, 0), 0.0)));
  EXPECT_EQ(sorted_depths(bowl, kAlongX), Depths{8.0});
  EXPECT_TRUE(bowl.inside(Vec3(-1, 0, 0)));
  EXPECT_FALSE(bowl.inside(Vec3(1, 0, 0)));
  EXPECT_NEAR(bowl.box().max.x, 0.0, 1e-4);
}

TEST(Solid, BoundsHideWhatRaysMissButDoNotCut) {
  const Solid large = bounded(ball(0, 2), ball(0, 1));
  EXPECT_EQ(sorted_depths(large, kAlongX), (Depths{8.0, 12.0}));
  EXPECT_TRUE(all(large, {Vec3(-10, 1.5, 0), Vec3(1, 0, 0)}).empty());
  EXPECT_TRUE(large.inside(Vec3(0, 1.5, 0)));
  const Solid around = bounded(ball(0, 2), ball(0, 20));
  EXPECT_EQ(sorted_depths(around, {Vec3(-10, 0, 0), Vec3(1, 0, 0)}), (Depths{8.0, 12.0}));
  EXPECT_EQ(all(around, {Vec3(-10, 1.5, 0), Vec3(1, 0, 0)}).size(), 2u);
}

TEST(Solid, SixPlanesMakeABoxWithFiniteBounds) {
  std::vector<Solid> sides;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 n(0.0);
    n[axis] = 1.0;
    sides.push_back(solid_of(make_plane(n, 1.0)));
    sides.push_back(solid_of(make_plane(-n, 1.0)));
  }
  const Solid box = combined(Kind::intersection, sides);
  EXPECT_EQ(sorted_depths(box, kAlongX), (Depths{9.0, 11.0}));
  ASSERT_TRUE(is_bounded(box.box()));
  EXPECT_NEAR(box.box().min.y, -1.0, 1e-4);
  EXPECT_NEAR(box.box().max.z, 1.0, 1e-4);
}

TEST(Solid, ComplementsInAnIntersectionDoNotLimitItsBox) {
  const Solid hollowed = combined(Kind::intersection, {ball(0, 2), inverted_ball(0, 1)});
  EXPECT_NEAR(hollowed.box().max.x, 2.0, 1e-4);
  EXPECT_EQ(sorted_depths(hollowed, kAlongX), (Depths{8.0, 9.0, 11.0, 12.0}));
}

TEST(Solid, HiddenMembersFollowTheirCombination) {
  Solid member = ball(-1, 2);
  member.hidden_from = kHiddenFromPrimary | kHiddenFromReflection | kHiddenFromShadow;
  const std::vector<Solid> members = {member, ball(1, 2)};
  const Solid together = combined(Kind::union_, members);
  EXPECT_EQ(all(together, kAlongX, kHiddenFromPrimary).size(), 4u);
  EXPECT_EQ(all(together, kAlongX, kHiddenFromReflection).size(), 2u);
  EXPECT_EQ(all(together, kAlongX, kHiddenFromShadow).size(), 4u);
  const Solid merged = combined(Kind::merge, members);
  EXPECT_EQ(sorted_depths(merged, kAlongX, kHiddenFromPrimary), (Depths{9.0, 13.0}));
  EXPECT_EQ(sorted_depths(merged, kAlongX, kHiddenFromReflection), (Depths{9.0, 13.0}));
  EXPECT_EQ(sorted_depths(merged, kAlongX, kHiddenFromShadow), (Depths{7.0, 13.0}));
  const Solid lens = combined(Kind::intersection, members);
  EXPECT_EQ(all(lens, kAlongX, kHiddenFromReflection).size(), 2u);
}

TEST(Solid, CombinationsTurnTheOrderOfEachMemberAround) {
  // The near crossing of each member comes last, as on POV-Ray's stack.
  const Solid lens = combined(Kind::intersection, {ball(0, 2, 1), ball(0, 3, 2)});
  const std::vector<Crossing> found = all(lens, kAlongX);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].depth, 12.0);
  EXPECT_EQ(found[1].depth, 8.0);
}

TEST(Solid, IsPlainWhileNothingCutsOrBoundsItsShape) {
  EXPECT_TRUE(ball(0, 2).is_plain());
  EXPECT_FALSE(clipped(ball(0, 2), ball(1, 2)).is_plain());
  EXPECT_FALSE(bounded(ball(0, 2), ball(1, 2)).is_plain());
  EXPECT_FALSE(combined(Kind::union_, {}).is_plain());
  EXPECT_TRUE(all(combined(Kind::union_, {}), Ray{Vec3(0.0), Vec3(1, 0, 0)}).empty());
  EXPECT_FALSE(combined(Kind::union_, {}).inside(Vec3(0.0)));
  EXPECT_TRUE(combined(Kind::intersection, {}).inside(Vec3(0.0)));
  EXPECT_LE(sizeof(Solid), 96u) << "a scene may have millions";
}

TEST(Solid, CopiesOfACombinationAreChangedOneByOne) {
  const Solid whole = combined(Kind::union_, {ball(-3, 1), ball(3, 1)});
  const Solid half = clipped(whole, solid_of(make_plane(Vec3(1, 0, 0), 0.0)));
  EXPECT_TRUE(whole.inside(Vec3(3, 0, 0)));
  EXPECT_FALSE(half.inside(Vec3(3, 0, 0)));
  EXPECT_TRUE(half.inside(Vec3(-3, 0, 0)));
}

/// A random tree of spheres and boxes, some of them complements.
Solid random_tree(std::mt19937& random, int levels) {
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  std::uniform_int_distribution<int> choice(0, 5);
  if (levels == 0) {
    const Vec3 center(place(random), place(random), place(random));
    ShapePtr shape = choice(random) < 3 ? make_sphere(center, 1.0) : make_box(center - Vec3(0.7), center + Vec3(0.7));
    return solid_of(choice(random) == 0 ? shape->inverted() : shape);
  }
  const Kind kinds[] = {Kind::union_, Kind::intersection, Kind::merge};
  std::vector<Solid> members;
  const int count = choice(random) == 0 ? 20 : 3;  // many members are kept in a tree
  for (int i = 0; i < count; ++i) members.push_back(random_tree(random, levels - 1));
  return combined(kinds[choice(random) % 3], std::move(members));
}

/// The rule itself, without boxes and trees.
bool plainly_inside(const Solid& solid, const Vec3& p) {
  const auto holds = [&](const Solid& m) { return plainly_inside(m, p); };
  if (solid.kind == Kind::shape) return solid.shape->inside(p);
  if (solid.kind == Kind::intersection) return std::ranges::all_of(solid.members(), holds);
  return std::ranges::any_of(solid.members(), holds);
}

std::vector<Crossing> plain_crossings(const Solid& solid, const Ray& ray) {
  std::vector<Crossing> out;
  if (solid.kind == Kind::shape) solid.shape->crossings(ray, out);
  for (const Solid& member : solid.members()) {
    std::vector<Crossing> some = plain_crossings(member, ray);
    if (solid.kind != Kind::union_) std::reverse(some.begin(), some.end());
    for (const Crossing& c : some) {
      bool counts = true;
      for (const Solid& other : solid.members()) {
        if (&other == &member || solid.kind == Kind::union_) continue;
        counts = counts && plainly_inside(other, ray.at(c.depth)) == (solid.kind == Kind::intersection);
      }
      if (counts) out.push_back(c);
    }
  }
  return out;
}

TEST(Solid, BoxesAndTreesNeverChangeTheAnswer) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  std::size_t count = 0;
  for (int tree = 0; tree < 60; ++tree) {
    const Solid boxed = random_tree(random, 2);
    for (int i = 0; i < 200; ++i) {
      const Vec3 from(place(random), place(random), place(random));
      const Vec3 to(place(random) * 0.3, place(random) * 0.3, place(random) * 0.3);
      const Ray ray{from, (to - from).normalized()};
      const std::vector<Crossing> a = all(boxed, ray);
      const std::vector<Crossing> b = plain_crossings(boxed, ray);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t k = 0; k < a.size(); ++k) {
        ASSERT_EQ(a[k].depth, b[k].depth);
        ASSERT_EQ(a[k].shape, b[k].shape);
        ASSERT_TRUE(boxed.box().intersects(ray.at(a[k].depth)));
      }
      ASSERT_EQ(boxed.inside(from), plainly_inside(boxed, from));
      count += a.size();
    }
  }
  EXPECT_GT(count, 3000u);
}

}  // namespace
}  // namespace firstlight::render
