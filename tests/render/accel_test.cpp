#include "render/accel/accel.h"

#include "tests/render/accel_test_support.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <random>

namespace firstlight::render {
namespace {

using Kind = Solid::Kind;

void expect_same(const Hit& a, const Hit& b) {
  ASSERT_EQ(a.part, b.part);
  ASSERT_EQ(a.depth, b.depth);
  ASSERT_EQ(a.face, b.face);
  ASSERT_EQ(a.shape, b.shape);
  ASSERT_EQ(a.solid, b.solid);
}

TEST(Accel, AgreesToTheBitWithAskingEverySolid) {
  for (const int count : {0, 1, 2, 9, 400}) {
    const Scene scene = mixed_scene(static_cast<unsigned>(count), count);
    const Accel accel(scene);
    const std::vector<RayQuery> queries = random_queries(3, 4000);
    std::vector<Hit> hits(queries.size());
    std::vector<std::uint8_t> blocked(queries.size());
    accel.closest(queries, hits);
    accel.occluded(queries, blocked);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SCOPED_TRACE(i);
      expect_same(hits[i], brute_closest(scene, queries[i]));
      ASSERT_EQ(blocked[i] != 0, brute_occluded(scene, queries[i]));
    }
  }
}

TEST(Accel, AnswersDoNotDependOnTheBlock) {
  const Scene scene = mixed_scene(5, 300);
  const Accel accel(scene);
  const std::vector<RayQuery> queries = random_queries(6, 1000);
  std::vector<Hit> whole(queries.size());
  accel.closest(queries, whole);
  for (const std::size_t block : {std::size_t{1}, std::size_t{7}, std::size_t{64}}) {
    for (std::size_t first = 0; first < queries.size(); first += block) {
      const std::size_t size = std::min(block, queries.size() - first);
      std::vector<Hit> some(size);
      accel.closest(std::span(queries).subspan(first, size), some);
      for (std::size_t i = 0; i < size; ++i) expect_same(some[i], whole[first + i]);
    }
  }
}

/// Spheres of many sizes, so most leaves are groups of them, and more planes than are tested at once.
Scene spheres_and_planes(unsigned seed) {
  Dice dice(seed);
  Scene scene;
  for (int i = 0; i < 700; ++i) {
    Solid solid = solid_of(make_sphere(dice.point(5.0), std::pow(10.0, dice.between(-2.5, 0.0))));
    if (dice.below(9) == 0) solid.hidden_from = static_cast<std::uint8_t>(1 << dice.below(3));
    add_solid(scene, std::move(solid), dice.below(3) != 0);
  }
  for (int i = 0; i < 19; ++i) {
    Solid solid = solid_of(make_plane(dice.point(1.0), dice.between(5.0, 9.0)));
    if (i >= 8 && dice.below(2) == 0) solid.hidden_from = static_cast<std::uint8_t>(1 << dice.below(3));
    add_solid(scene, std::move(solid), dice.below(3) != 0);
  }
  return scene;
}

TEST(Accel, GroupsOfSpheresAndPlanesAgreeToTheBitWithAskingEverySolid) {
  const Scene scene = spheres_and_planes(21);
  const Accel accel(scene);
  for (const RayQuery& query : random_queries(22, 6000)) {
    Hit hit;
    std::uint8_t blocked = 2;
    accel.closest({&query, 1}, {&hit, 1});
    accel.occluded({&query, 1}, {&blocked, 1});
    expect_same(hit, brute_closest(scene, query));
    ASSERT_EQ(blocked != 0, brute_occluded(scene, query));
  }
}

TEST(Accel, AnswersDoNotDependOnTheInstructionSet) {
  const Scene scene = mixed_scene(23, 200);
  const Scene round = spheres_and_planes(24);
  const std::vector<RayQuery> queries = random_queries(25, 2000);
  for (const Scene* each : {&scene, &round}) {
    const Accel accel(*each);
    std::vector<Hit> best(queries.size());
    std::vector<std::uint8_t> best_blocked(queries.size());
    accel.closest(queries, best);
    accel.occluded(queries, best_blocked);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::GetChosenTarget().Update(target);
      std::vector<Hit> hits(queries.size());
      std::vector<std::uint8_t> blocked(queries.size());
      accel.closest(queries, hits);
      accel.occluded(queries, blocked);
      for (std::size_t i = 0; i < queries.size(); ++i) expect_same(hits[i], best[i]);
      EXPECT_EQ(blocked, best_blocked);
    }
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
}

TEST(Accel, RaysAlmostAlongAnAxisMeetWhatTheyTouch) {
  // Small directions are where a box test in float would go wrong first.
  const Scene scene = spheres_and_planes(26);
  const Accel accel(scene);
  Dice dice(27);
  for (int i = 0; i < 4000; ++i) {
    const int axis = dice.below(3);
    Vec3 d(0.0);
    for (int k = 0; k < 3; ++k) d[k] = (dice.below(2) == 0 ? 1.0 : -1.0) * std::pow(10.0, dice.between(-40.0, -3.0));
    d[axis] = dice.below(2) == 0 ? 1.0 : -1.0;
    const RayQuery query{{dice.point(5.0), d.normalized()}, 1e-4, 1e7, 0};
    Hit hit;
    accel.closest({&query, 1}, {&hit, 1});
    expect_same(hit, brute_closest(scene, query));
  }
}

TEST(Accel, SmallThingsFarFromTheMiddleOfTheWorldAreMet) {
  // Where the coordinates of floats are coarser than the things, boxes are tested in double.
  for (const double far : {1e3, 1e5, 1e6}) {
    Scene scene;
    Dice dice(28);
    const Vec3 place(far, -0.5 * far, 0.25 * far);
    for (int i = 0; i < 300; ++i) add_solid(scene, solid_of(make_sphere(place + dice.point(0.5), 0.02)));
    const Accel accel(scene);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 from = place + dice.point(3.0);
      const RayQuery query{{from, (place + dice.point(0.5) - from).normalized()}, 1e-4, 1e7, 0};
      Hit hit;
      std::uint8_t blocked = 2;
      accel.closest({&query, 1}, {&hit, 1});
      accel.occluded({&query, 1}, {&blocked, 1});
      expect_same(hit, brute_closest(scene, query));
      ASSERT_EQ(blocked != 0, hit.part != kNoIndex);
      met += hit.part != kNoIndex;
    }
    EXPECT_GT(met, 200);
  }
}

TEST(Accel, OfEqualDepthsTheLowerSolidWins) {
  Scene scene;
  for (int i = 0; i < 40; ++i) {
    add_solid(scene, solid_of(i % 2 == 0 ? make_sphere(Vec3(0.0), 1.0) : make_box(Vec3(-1.0), Vec3(1.0))));
  }
  const Accel accel(scene);
  const RayQuery query{{Vec3(0, 0, -5), Vec3(0, 0, 1)}, 1e-4, 1e7, 0};
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});
  EXPECT_EQ(hit.solid, 0u);
  EXPECT_EQ(hit.depth, 4.0);
}

TEST(Accel, InsideOneSolidTheLastOfEqualsWins) {
  // Both members are met at depth 4; each comes off POV-Ray's stack in turn, so the second member's is taken.
  Scene scene;
  add_solid(scene, combined(Kind::intersection, {solid_of(make_box(Vec3(-1.0), Vec3(1.0))),
                                                 solid_of(make_box(Vec3(-2, -2, -1), Vec3(2, 2, 3)))}));
  const Accel accel(scene);
  const RayQuery query{{Vec3(0, 0, -5), Vec3(0, 0, 1)}, 1e-4, 1e7, 0};
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});
  EXPECT_EQ(hit.depth, 4.0);
  EXPECT_EQ(hit.part, 1u);
}

TEST(Accel, DepthLimitsAreOpen) {
  Scene scene;
  add_solid(scene, solid_of(make_sphere(Vec3(0.0), 1.0)));
  const Accel accel(scene);
  const auto depth_within = [&](double low, double high) {
    const RayQuery query{{Vec3(0, 0, -5), Vec3(0, 0, 1)}, low, high, 0};
    Hit hit;
    accel.closest({&query, 1}, {&hit, 1});
    std::uint8_t blocked = 2;
    accel.occluded({&query, 1}, {&blocked, 1});
    EXPECT_EQ(blocked, hit.part == kNoIndex ? 0 : 1);
    return hit.part == kNoIndex ? 0.0 : hit.depth;
  };
  EXPECT_EQ(depth_within(0.0, 4.0), 0.0);
  EXPECT_EQ(depth_within(0.0, 4.1), 4.0);
  EXPECT_EQ(depth_within(4.0, 10.0), 6.0);
  EXPECT_EQ(depth_within(4.0, 6.0), 0.0);
}

TEST(Accel, SmallThingsAreMetUnderAHugeSkyAndFromFarAway) {
  Scene scene;
  Dice dice(9);
  for (int i = 0; i < 500; ++i) add_solid(scene, solid_of(make_sphere(dice.point(0.05), 0.002)));
  add_solid(scene, solid_of(make_sphere(Vec3(0.0), 1e6)));
  const Accel accel(scene);
  std::vector<RayQuery> queries;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 from = dice.point(1.0) * std::pow(10.0, dice.between(-2.0, 1.5));
    queries.push_back({{from, (dice.point(0.05) - from).normalized()}, 1e-6, 1e7, 0});
  }
  std::vector<Hit> hits(queries.size());
  accel.closest(queries, hits);
  int small = 0;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    expect_same(hits[i], brute_closest(scene, queries[i]));
    small += hits[i].solid < 500u;
  }
  EXPECT_GT(small, 500);
}

TEST(Accel, RaysInThePlaneOfAFaceAreSafe) {
  Scene scene;
  for (int i = 0; i < 20; ++i) add_solid(scene, solid_of(make_box(Vec3(2.0 * i, 0, 0), Vec3(2.0 * i + 1, 1, 0))));
  add_solid(scene, solid_of(make_triangle(Vec3(0, 2, 0), Vec3(1, 2, 0), Vec3(0, 3, 0))));
  const Accel accel(scene);
  for (const double y : {0.0, 0.5, 1.0, 2.0, 3.0}) {
    for (const double z : {0.0, -0.0}) {
      const RayQuery query{{Vec3(-5, y, 0), Vec3(1, 0, z)}, 1e-4, 1e7, 0};
      Hit hit;
      accel.closest({&query, 1}, {&hit, 1});
      expect_same(hit, brute_closest(scene, query));
    }
  }
}

TEST(Accel, SolidsOnOnePlaceAndSolidsWithoutSizeBuildATree) {
  Scene scene;
  for (int i = 0; i < 3000; ++i) add_solid(scene, solid_of(make_sphere(Vec3(1, 2, 3), 0.5)));
  for (int i = 0; i < 100; ++i) add_solid(scene, solid_of(make_sphere(Vec3(0.0), 0.0)));
  double radius = 1e-6;
  for (int i = 0; i < 200; ++i, radius *= 1.3) add_solid(scene, solid_of(make_sphere(Vec3(-2, 0, 0), radius)));
  const Accel accel(scene);
  const RayQuery query{{Vec3(1, 2, -5), Vec3(0, 0, 1)}, 1e-4, 1e7, 0};
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});
  expect_same(hit, brute_closest(scene, query));
}

TEST(Accel, RaysAndSolidsThatAreNoNumbersMeetNothingAndDoNoHarm) {
  Scene scene;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  add_solid(scene, solid_of(make_sphere(Vec3(none, 0, 0), 1.0)));
  add_solid(scene, solid_of(make_sphere(Vec3(0.0), endless)));
  add_solid(scene, solid_of(make_box(Vec3(-endless), Vec3(none))));
  add_solid(scene, solid_of(make_torus(1e200, 1e200)));
  for (int i = 0; i < 30; ++i) add_solid(scene, solid_of(make_box(Vec3(i), Vec3(i + 0.5))));
  const Accel accel(scene);
  for (const Vec3& direction : {Vec3(none, 0, 0), Vec3(0.0), Vec3(endless, 0, 0), Vec3(1, 0, 0)}) {
    const RayQuery query{{Vec3(-1, 0.25, 0.25), direction}, 1e-4, 1e7, 0};
    Hit hit;
    std::uint8_t blocked = 0;
    accel.closest({&query, 1}, {&hit, 1});
    accel.occluded({&query, 1}, {&blocked, 1});
    if (direction == Vec3(1, 0, 0)) {
      EXPECT_EQ(hit.depth, 1.0);
    }
  }
}

}  // namespace
}  // namespace firstlight::render
