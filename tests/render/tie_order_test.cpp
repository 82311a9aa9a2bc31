#include "render/accel/tie_order.h"

#include "render/accel/accel.h"
#include "tests/render/dice.h"
#include "tests/render/solid_test_support.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <vector>

namespace firstlight::render {
namespace {

const RayQuery kAlongZ{{Vec3(0.1, 0.2, -5.0), Vec3(0.0, 0.0, 1.0)}, 1e-4, 1e7, 0};

std::uint32_t seen(const Scene& scene, const RayQuery& query = kAlongZ) {
  const Accel accel(scene);
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});
  return hit.solid;
}

Scene scene_of(const std::vector<ShapePtr>& shapes) {
  Scene scene;
  for (const ShapePtr& shape : shapes) add_solid(scene, solid_of(shape));
  return scene;
}

ShapePtr ball(double x = 0.0) { return make_sphere(Vec3(x, 0.0, 0.0), 1.0); }
ShapePtr floor() { return make_plane(Vec3(0.0, 1.0, 0.0), -3.0); }

TEST(TieOrder, FewObjectsAreAskedInTheOrderOfTheText) {
  EXPECT_EQ(seen(scene_of({ball(), ball()})), 0u);
  EXPECT_EQ(seen(scene_of({make_plane(Vec3(0, 0, -1), 1.0), make_box(Vec3(-1), Vec3(1))})), 0u);
  EXPECT_EQ(seen(scene_of({make_box(Vec3(-1), Vec3(1)), make_plane(Vec3(0, 0, -1), 1.0)})), 0u);
}

TEST(TieOrder, LightsCountAmongTheObjects) {
  Scene scene = scene_of({make_box(Vec3(-1), Vec3(1)), make_plane(Vec3(0, 0, -1), 1.0)});
  scene.lights.emplace_back();
  EXPECT_EQ(seen(scene), 1u) << "what has no bounds comes first in a tree";
}

TEST(TieOrder, OfTwinsTheFirstIsSeenButTheLastBesideAPlane) {
  // As POV-Ray's heap has it.
  EXPECT_EQ(seen(scene_of({ball(), ball(), ball(9)})), 0u);
  EXPECT_EQ(seen(scene_of({ball(), ball(), floor()})), 1u);
}

TEST(TieOrder, WhatIsEnteredFirstIsSeen) {
  const ShapePtr box = make_box(Vec3(-1), Vec3(1));
  const ShapePtr disc = make_disc(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 0.0, 1.0), 0.5, 0.0);  // its box is 0.002 thick
  EXPECT_EQ(seen(scene_of({box, disc, ball(5), ball(7)})), 1u);
  EXPECT_EQ(seen(scene_of({disc, box, ball(5), ball(7)})), 0u);
}

TEST(TieOrder, WhatIsNotSeenIsNotInTheWay) {
  Scene scene = scene_of({ball(), ball(), ball(9)});
  scene.solids[0].hidden_from = kHiddenFromPrimary;
  RayQuery query = kAlongZ;
  query.hidden_bit = kHiddenFromPrimary;
  EXPECT_EQ(seen(scene, query), 1u);
  EXPECT_EQ(seen(scene), 0u);
}

TEST(TieOrder, PlanesMayLieInOnePlace) {
  const auto wall = [](double sign) { return make_plane(Vec3(0, 0, sign), sign * 2.0); };
  EXPECT_EQ(seen(scene_of({wall(-1.0), wall(1.0), floor()})), 0u);
  EXPECT_EQ(seen(scene_of({floor(), wall(-1.0), wall(1.0)})), 2u) << "the last takes the place of what leaves the heap";
}

/// Boxes, discs, spheres and planes on a grid, many of them in one place.
Scene crowded_scene(unsigned seed) {
  Dice dice(seed);
  Scene scene;
  const auto place = [&] { return Vec3(dice.below(4), dice.below(4), dice.below(4)) - Vec3(2.0); };
  for (int i = 0; i < 120; ++i) {
    const Vec3 p = place();
    switch (dice.below(4)) {
      case 0:
        add_solid(scene, solid_of(make_sphere(p, 0.5)));
        break;
      case 1:
        add_solid(scene, solid_of(make_disc(p, Vec3(0, 0, 1), 0.7, 0.1)));
        break;
      case 2:
        add_solid(scene, combined(Solid::Kind::intersection,
                                  {solid_of(make_box(p, p + Vec3(1.0))), solid_of(make_sphere(p, 1.4))}));
        break;
      default:
        add_solid(scene, solid_of(make_box(p, p + Vec3(1.0))));
    }
  }
  for (int i = 0; i < 3; ++i) add_solid(scene, solid_of(make_plane(Vec3(0, 0, 1), 2.0)));
  return scene;
}

TEST(TieOrder, AnswersDoNotDependOnTheBlockNorOnTheInstructionSet) {
  const Scene scene = crowded_scene(31);
  const Accel accel(scene);
  Dice dice(32);
  std::vector<RayQuery> queries;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 from = dice.point(6.0);
    queries.push_back({{from, (dice.point(2.0) - from).normalized()}, 1e-4, 1e7, 0});
  }
  std::vector<Hit> whole(queries.size());
  accel.closest(queries, whole);
  const auto expect_equal = [&](const std::vector<Hit>& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
      ASSERT_EQ(hits[i].solid, whole[i].solid);
      ASSERT_EQ(hits[i].depth, whole[i].depth);
      ASSERT_EQ(hits[i].face, whole[i].face);
    }
  };
  std::vector<Hit> single(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) accel.closest({&queries[i], 1}, {&single[i], 1});
  expect_equal(single);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::GetChosenTarget().Update(target);
    std::vector<Hit> hits(queries.size());
    accel.closest(queries, hits);
    expect_equal(hits);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(SlabTree, UpToFourStayTogetherInTheirOrderAlongTheLongestAxis) {
  std::vector<Extent> extents;
  for (const double x : {3.0, 1.0, 2.0}) extents.push_back(extent(*ball(4.0 * x)));
  const SlabTree tree(extents);
  const auto children = tree.children(tree.node(tree.root()));
  EXPECT_EQ(std::vector(children.begin(), children.end()), (std::vector<std::uint32_t>{1, 2, 0}));
}

TEST(SlabTree, WhatHasNoBoundsIsTheFirstGroupOfTheRoot) {
  const std::vector<Extent> extents = {extent(*ball()), extent(*floor()), extent(*ball(4.0))};
  const SlabTree tree(extents);
  const SlabTree::Node& root = tree.node(tree.root());
  EXPECT_TRUE(root.unbounded);
  ASSERT_EQ(root.count, 3u);
  const SlabTree::Node& group = tree.node(tree.children(root)[0]);
  EXPECT_TRUE(group.unbounded);
  ASSERT_EQ(group.count, 1u);
  EXPECT_EQ(tree.children(group)[0], 1u);
}

TEST(SlabTree, TwoHeapsAreSplitBetweenThem) {
  std::vector<Extent> extents;
  for (const double x : {0.0, 100.0, 1.0, 101.0, 2.0, 102.0}) extents.push_back(extent(*ball(x)));
  const SlabTree tree(extents);
  const SlabTree::Node& root = tree.node(tree.root());
  ASSERT_EQ(root.count, 2u);
  for (const std::uint32_t child : tree.children(root)) EXPECT_EQ(tree.node(child).count, 3u);
}

TEST(SlabTree, ManyInOnePlaceAreOneGroup) {
  const std::vector<Extent> extents(500, extent(*ball()));
  const SlabTree tree(extents);
  EXPECT_EQ(tree.node(tree.root()).count, 500u);
}

}  // namespace
}  // namespace firstlight::render
