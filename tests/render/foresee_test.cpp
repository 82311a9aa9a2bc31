// Feelers that need not be traced, for their end is known by where they lead.

#include "render/accel/accel.h"

#include "tests/render/accel_test_support.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

/// The feeler of a point, as it would be traced.
RayQuery feeler(const Vec3& point, const Vec3& light) {
  const Vec3 way = light - point;
  const double distance = way.length();
  return {{point, way * (1.0 / distance)}, kShadowGap, distance - kShadowGap, kHiddenFromShadow};
}

/// Whether anything that casts a shadow, opaque or not, is in its way.
bool brute_shadowed(const Scene& scene, const RayQuery& feeler) {
  for (const Solid& solid : scene.solids) {
    if ((solid.hidden_from & kHiddenFromShadow) != 0) continue;
    std::vector<Crossing> all;
    solid.crossings(feeler.ray, kHiddenFromShadow, all);
    for (const Crossing& c : all) {
      if (c.depth > feeler.min_depth && c.depth < feeler.max_depth) return true;
    }
  }
  return false;
}

/// Where feelers begin: points on surfaces, and some anywhere.
struct Starts {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;

  Starts() = default;
  Starts(const Scene& scene, unsigned seed, int count) {
    for (const RayQuery& query : random_queries(seed, count)) {
      const Hit hit = brute_closest(scene, query);
      const bool is_met = hit.part != kNoIndex;
      const Vec3 point = is_met ? query.ray.at(hit.depth) : query.ray.origin;
      Vec3 normal = is_met ? hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face}) : Vec3(0, 1, 0);
      if (normal.dot(query.ray.direction) > 0.0) normal = -normal;
      add(point, normal);
    }
  }
  void add(const Vec3& point, const Vec3& normal) {
    points.push_back(point);
    normals.push_back(normal);
  }
};

/// The answers of Accel::foresee() for all starts and lights.
struct AllForeseen {
  std::vector<std::vector<Foreseen>> blocks;  ///< of kRaysAtOnce starts each, by light

  AllForeseen(const Scene& scene, const Starts& starts, bool from_both_sides = true,
              Foresight foresight = Foresight::some) {
    const Accel accel(scene, foresight);
    for (std::size_t first = 0; first < starts.points.size(); first += kRaysAtOnce) {
      Columns3<double> points;
      Columns3<double> normals;
      const std::size_t size = std::min(kRaysAtOnce, starts.points.size() - first);
      for (std::size_t i = 0; i < size; ++i) {
        points.set(i, starts.points[first + i]);
        normals.set(i, starts.normals[first + i]);
      }
      blocks.emplace_back(scene.lights.size());
      accel.foresee({points, normals, size, from_both_sides}, 0, scene.lights, blocks.back());
    }
  }
  bool clear(std::size_t start, std::size_t light) const {
    return (blocks[start / kRaysAtOnce][light].clear >> start % kRaysAtOnce & 1u) != 0;
  }
  bool blocked(std::size_t start, std::size_t light) const {
    return (blocks[start / kRaysAtOnce][light].blocked >> start % kRaysAtOnce & 1u) != 0;
  }
  /// The number of pairs of a start and a light that are told.
  std::size_t count() const {
    std::size_t count = 0;
    for (const std::vector<Foreseen>& lights : blocks) {
      for (const Foreseen& f : lights) count += static_cast<std::size_t>(std::popcount(f.clear | f.blocked));
    }
    return count;
  }
};

void expect_true(const Scene& scene, const Starts& starts, const AllForeseen& foreseen) {
  for (std::size_t i = 0; i < starts.points.size(); ++i) {
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
      const RayQuery query = feeler(starts.points[i], scene.lights[l].position);
      ASSERT_FALSE(foreseen.clear(i, l) && foreseen.blocked(i, l));
      if (foreseen.clear(i, l)) {
        ASSERT_FALSE(brute_shadowed(scene, query)) << "start " << i << ", light " << l;
      }
      if (foreseen.blocked(i, l)) {
        ASSERT_TRUE(brute_occluded(scene, query)) << "start " << i << ", light " << l;
      }
    }
  }
}

void add_lights(Scene& scene, unsigned seed, int count) {
  Dice dice(seed);
  for (int l = 0; l < count; ++l) {
    Light light;
    light.position = dice.point(l % 2 == 0 ? 4.0 : 30.0);
    scene.lights.push_back(light);
  }
}

/// Balls of all sizes, most of them opaque, over a floor.
Scene balls(unsigned seed, int count) {
  Dice dice(seed);
  Scene scene;
  add_solid(scene, solid_of(make_plane(Vec3(0, 1, 0), -4.0)));
  for (int i = 0; i < count; ++i) {
    Solid ball = solid_of(make_sphere(dice.point(4.0), std::pow(10.0, dice.between(-4.0, 0.2))));
    if (dice.below(10) == 0) ball.hidden_from = kHiddenFromShadow;
    add_solid(scene, ball, dice.below(10) != 0);
  }
  return scene;
}

TEST(Foreseen, IsNothingIfThatIsAskedFor) {
  Scene scene = balls(1, 30);
  add_lights(scene, 1, 3);
  const Starts starts(scene, 1, 200);
  EXPECT_GT(AllForeseen(scene, starts).count(), 100u);
  EXPECT_EQ(AllForeseen(scene, starts, true, Foresight::none).count(), 0u);
}

TEST(Foreseen, IsWhatIsMet) {
  for (unsigned seed = 31; seed < 37; ++seed) {
    Scene scene = seed % 2 == 0 ? balls(seed, 200) : mixed_scene(seed, 30);
    add_lights(scene, seed, 5);
    const Starts starts(scene, seed, 1500);
    const AllForeseen foreseen(scene, starts);
    expect_true(scene, starts, foreseen);
    EXPECT_GT(foreseen.count(), 100u);
  }
}

TEST(Foreseen, IsNearlyAllOfAFewBallsOnAFloor) {
  Scene scene;
  add_solid(scene, solid_of(make_plane(Vec3(0, 1, 0), 0.0)));
  for (int i = 0; i < 5; ++i) add_solid(scene, solid_of(make_sphere(Vec3(2.0 * i - 4.0, 0.5, 0.0), 0.3)));
  scene.lights.resize(1);
  scene.lights[0].position = Vec3(0.0, 10.0, 0.0);
  Starts starts;
  Dice dice(41);
  for (int i = 0; i < 2000; ++i) starts.add({dice.between(-8.0, 8.0), 0.0, dice.between(-8.0, 8.0)}, Vec3(0, 1, 0));
  const AllForeseen foreseen(scene, starts);
  expect_true(scene, starts, foreseen);
  EXPECT_GT(foreseen.count(), 2000u * 98 / 100);
}

TEST(Foreseen, SeesOutOfWhatIsAroundALight) {
  // A light in a room that is a box, with two balls: what is on its walls is clear of the room. And in a ball: what is
  // near the light is clear of it.
  Scene scene;
  add_solid(scene, solid_of(make_box(Vec3(-6, -5, -7), Vec3(6, 5, 7))));
  add_solid(scene, solid_of(make_sphere(Vec3(-3, 0, 0), 0.5)));
  add_solid(scene, solid_of(make_sphere(Vec3(1, 0, 0), 20.0)));
  scene.lights.resize(1);
  Starts starts;
  Dice dice(46);
  for (int i = 0; i < 2000; ++i) {
    Vec3 point = dice.point(5.0);
    if (i % 2 == 0) point.y = -5.0;
    starts.add(point, Vec3(0, 1, 0));
  }
  const AllForeseen foreseen(scene, starts);
  expect_true(scene, starts, foreseen);
  EXPECT_GT(foreseen.count(), 2000u * 98 / 100);
}

TEST(Foreseen, IsNotAskedOfFeelersAgainstTheNormal) {
  Scene scene = balls(47, 50);
  add_lights(scene, 47, 3);
  const Starts starts(scene, 48, 1000);
  const AllForeseen both(scene, starts);
  const AllForeseen front(scene, starts, false);
  for (std::size_t i = 0; i < starts.points.size(); ++i) {
    for (std::size_t l = 0; l < scene.lights.size(); ++l) {
      const bool faces = starts.normals[i].dot(scene.lights[l].position - starts.points[i]) >= 0.0;
      EXPECT_EQ(front.clear(i, l), faces && both.clear(i, l));
      EXPECT_EQ(front.blocked(i, l), faces && both.blocked(i, l));
    }
  }
}

TEST(Foreseen, IsNothingWhereSomethingWithoutBoundsIsNoPlane) {
  Scene scene;
  add_solid(scene, combined(Solid::Kind::intersection,
                            {solid_of(make_plane(Vec3(0, 1, 0), -50.0)), solid_of(make_plane(Vec3(1, 0, 0), -50.0))}));
  add_lights(scene, 42, 2);
  const Starts starts(scene, 42, 100);
  EXPECT_EQ(AllForeseen(scene, starts).count(), 0u);
}

TEST(Foreseen, IsCoarserWhereThereAreManyLightsOrMuchIsSeen) {
  Scene scene = balls(49, 400);
  add_lights(scene, 49, 200);
  const Starts starts(scene, 50, 64);
  const AllForeseen of_many_lights(scene, starts);
  expect_true(scene, starts, of_many_lights);
  EXPECT_GT(of_many_lights.count(), 1000u);

  Scene crowded;
  for (int i = 0; i < 30000; ++i) add_solid(crowded, solid_of(make_sphere(Vec3(0.0, 0.0, 1e-4 * i), 3.0)));
  crowded.lights.resize(1);
  crowded.lights[0].position = Vec3(0, 7, 0);
  expect_true(crowded, starts, AllForeseen(crowded, starts));
}

TEST(Foreseen, ToleratesStartsAndLightsThatAreNoNumbers) {
  Scene scene = balls(51, 50);
  add_lights(scene, 51, 2);
  Starts starts(scene, 52, 64);
  starts.points[3] = Vec3(std::numeric_limits<double>::quiet_NaN());
  starts.points[5] = Vec3(std::numeric_limits<double>::infinity(), 0, 0);
  starts.points[7] = scene.lights[0].position;
  scene.lights[1].position = Vec3(std::numeric_limits<double>::quiet_NaN());
  const AllForeseen foreseen(scene, starts);
  EXPECT_FALSE(foreseen.blocked(3, 0));
  EXPECT_FALSE(foreseen.blocked(7, 0));
}

TEST(Foreseen, DoesNotDependOnTheInstructionSet) {
  Scene scene = balls(43, 200);
  add_lights(scene, 43, 8);
  const Starts starts(scene, 44, 1000);
  const AllForeseen best(scene, starts);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::GetChosenTarget().Update(target);
    EXPECT_EQ(AllForeseen(scene, starts).blocks, best.blocks);
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace
}  // namespace firstlight::render
