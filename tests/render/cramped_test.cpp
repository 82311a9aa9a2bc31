// Room that boxes have at 0, and boxes that are smaller than what is in them.

#include "render/scene/extent.h"
#include "render/scene/scene_builder.h"
#include "render/trace/medium_table.h"
#include "render/trace/primary.h"
#include "render/trace/start_medium.h"

#include "tests/render/accel_test_support.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

Object object_of(ShapePtr shape) {
  Object object;
  object.cramped = shape->given_bounds() != shape->bounds();
  object.shape = std::move(shape);
  return object;
}

ObjectList list(std::vector<Object> objects) { return std::make_shared<const std::vector<Object>>(std::move(objects)); }

Object combined_of(Object::Kind kind, std::vector<Object> children) {
  Object object;
  object.kind = kind;
  object.cramped = true;
  object.children = list(std::move(children));
  return object;
}

Object bounded_by(Object object, ShapePtr bound) {
  object.cramped = true;
  object.extras.change().bounded_by = list({object_of(std::move(bound))});
  finish_box(object);
  return object;
}

std::unique_ptr<const Scene> scene_of(const Object& object, const BoundingRules& rules = {}) {
  SceneBuilder builder;
  builder.set_bounding(rules);
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  builder.add(object, texture);
  return builder.build();
}

/// The depth at which a ray along z meets the scene, from z = -10; -1 where it meets nothing.
double depth_at(const Scene& scene, double x, double y) {
  const Accel accel(scene);
  const RayQuery query{{{x, y, -10.0}, {0.0, 0.0, 1.0}}, 1e-4, 1e6, 0};
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});
  return hit.part == kNoIndex ? -1.0 : hit.depth;
}

TEST(Room, AFaceAtZeroIsWhole) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sense : {1.0, -1.0}) {
      Vec3 normal(0.0);
      normal[axis] = sense;
      Scene scene;
      add_solid(scene, combined(Solid::Kind::intersection,
                                {solid_of(make_plane(normal, 0.0)), solid_of(make_sphere(Vec3(0.0), 1.0))}));
      add_solid(scene, clipped(solid_of(make_plane(normal, 0.0)), solid_of(make_sphere(Vec3(0.0), 1.0))));
      const Accel accel(scene);
      Dice dice(static_cast<unsigned>(axis));
      for (int i = 0; i < 300; ++i) {
        Vec3 on_face = dice.point(0.5);
        on_face[axis] = 0.0;
        Vec3 from = dice.point(8.0);
        from[axis] = sense * dice.between(0.1, 8.0);
        const Vec3 way = on_face - from;
        const RayQuery query{{from, way * (1.0 / way.length())}, 1e-4, 1e6, 0};
        Hit hit;
        accel.closest({&query, 1}, {&hit, 1});
        ASSERT_NE(hit.part, kNoIndex) << from.x << ' ' << from.y << ' ' << from.z;
        EXPECT_NEAR(hit.depth, way.length(), 1e-6);
      }
    }
  }
}

TEST(Cramped, ABoundIsTheBoxOnlyWhereItIsSmaller) {
  const Object small = bounded_by(object_of(make_sphere(Vec3(0.0), 1.0)), make_box(Vec3(-0.5), Vec3(0.5)));
  const auto cut = scene_of(small);
  EXPECT_NEAR(depth_at(*cut, 0.4, 0.0), 10.0 - std::sqrt(1.0 - 0.16), 1e-9);
  EXPECT_EQ(depth_at(*cut, 0.6, 0.0), -1.0);
  const Object large = bounded_by(object_of(make_sphere(Vec3(0.0), 1.0)), make_box(Vec3(-0.5), Vec3(3.0)));
  EXPECT_GT(depth_at(*scene_of(large), -0.6, 0.0), 0.0);
}

TEST(Cramped, AShapeThatIsMovedByItsUnionHasItsOwnBoxAgain) {
  Object both = combined_of(Object::Kind::union_,
                            {bounded_by(object_of(make_sphere(Vec3(0.0), 1.0)), make_box(Vec3(-0.5), Vec3(0.5)))});
  EXPECT_EQ(depth_at(*scene_of(both), 0.6, 0.0), -1.0);
  place(both, Transform::translation(Vec3(0.0, 1.0, 0.0)));
  EXPECT_GT(depth_at(*scene_of(both), 0.6, 1.0), 0.0);
  EXPECT_EQ(depth_at(*scene_of(both, {.remove_bounds = false}), 0.6, 1.0), -1.0);
}

TEST(Cramped, BoundsOfFiniteUnionsCountUnlessTheyAreSplit) {
  const auto bounded_union = [](ShapePtr second) {
    return bounded_by(
        combined_of(Object::Kind::union_, {object_of(make_sphere(Vec3(0.0), 1.0)), object_of(std::move(second))}),
        make_box(Vec3(-0.5), Vec3(0.5)));
  };
  const Object finite = bounded_union(make_sphere(Vec3(3.0, 0.0, 0.0), 1.0));
  EXPECT_EQ(depth_at(*scene_of(finite), 0.6, 0.0), -1.0);
  EXPECT_GT(depth_at(*scene_of(finite, {.split_unions = true}), 0.6, 0.0), 0.0);
  const Object endless = bounded_union(make_plane(Vec3(0.0, 1.0, 0.0), -5.0));
  EXPECT_EQ(depth_at(*scene_of(endless, {.split_unions = true}), 0.6, 0.0), -1.0);
}

TEST(Cramped, TheBoxOfACombinationGrowsWithEachTurn) {
  const Object disc = object_of(make_disc(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 1.0, 0.0));
  Object cut = combined_of(Object::Kind::intersection, {disc, object_of(make_box(Vec3(-2.0), Vec3(2.0)))});
  EXPECT_NEAR(extent(cut).length[1], 2.0, 1e-6);
  for (int i = 0; i < 2; ++i) place(cut, Transform::rotation(Vec3(0.0, 0.0, 45.0)));
  EXPECT_NEAR(extent(cut).length[1], 4.0, 1e-5);
  EXPECT_NEAR(extent(cut).length[2], 0.002, 1e-6);
}

TEST(Cramped, WhatIsBeforeTheBoxIsMetButNotBeforeTheRayHasComeToTheBox) {
  // All of the box below the disc's plane is left, and seen by the rays that pass the flat box of the disc.
  const Object disc = object_of(make_disc(Vec3(0.0), Vec3(0.0, 0.0, -1.0), 1.0, 0.0));
  const Object cut =
      combined_of(Object::Kind::intersection, {disc, object_of(make_box(Vec3(-2.0, -2.0, -3.0), Vec3(2.0)))});
  SceneBuilder builder;
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  builder.add(cut, texture);
  EXPECT_NEAR(depth_at(*builder.build(), 0.5, 0.0), 10.0, 1e-9);

  Object turned = cut;
  place(turned, Transform::rotation(Vec3(0.0, 180.0, 0.0)));  // now the near half is left
  EXPECT_NEAR(depth_at(*scene_of(turned), 0.5, 0.0), 8.0, 1e-9);
  EXPECT_EQ(depth_at(*scene_of(turned), 1.5, 0.0), -1.0);
  builder.add(turned, texture);
  builder.add(object_of(make_box(Vec3(-2.0, -2.0, -1.0), Vec3(2.0, 2.0, -0.5))), texture);
  const auto scene = builder.build();
  EXPECT_NEAR(depth_at(*scene, 0.5, 0.0), 9.0, 1e-9) << "the wall is met before the disc's box";
}

TEST(Cramped, OfANegativeRadiusThereIsNothingToBeSeen) {
  EXPECT_EQ(depth_at(*scene_of(object_of(make_sphere(Vec3(0.0), -1.0))), 0.0, 0.0), -1.0);
  Object ellipsoid = object_of(make_sphere(Vec3(0.0), -1.0));
  place(ellipsoid, Transform::scaling(Vec3(1.0, 2.0, 1.0)));
  EXPECT_NEAR(depth_at(*scene_of(ellipsoid), 0.0, 0.0), 9.0, 1e-9);
  const Object cut = combined_of(Object::Kind::intersection,
                                 {object_of(make_sphere(Vec3(0.0), -1.0)), object_of(make_box(Vec3(-0.5), Vec3(0.5)))});
  EXPECT_NEAR(depth_at(*scene_of(cut), 0.0, 0.0), 9.5, 1e-9);
  EXPECT_EQ(depth_at(*scene_of(object_of(make_torus(1.0, -0.3))), 1.0, 0.0), -1.0);
}

/// Whether a camera at `point` starts in the only object of a scene.
bool starts_in(const Object& object, const Vec3& point) {
  const auto scene = scene_of(object);
  MediumTable media;
  return medium_at(*scene, media, point) != MediumTable::kOutside;
}

TEST(Start, IsInsideOfWhatIsAroundItWithinItsBox) {
  EXPECT_TRUE(starts_in(object_of(make_sphere(Vec3(0.0), 1.0)), Vec3(0.0)));
  EXPECT_FALSE(starts_in(object_of(make_disc(Vec3(0.0), Vec3(0.0, 0.0, 1.0), 1.0, 0.0)), Vec3(0.0, 0.0, -1.0)));
  EXPECT_TRUE(starts_in(object_of(make_plane(Vec3(0.0, 1.0, 0.0), 0.0)), Vec3(0.0, -5.0, 0.0)));
  Object inverse = object_of(make_sphere(Vec3(0.0), 1.0));
  invert(inverse);
  EXPECT_FALSE(starts_in(inverse, Vec3(0.0, 5.0, 0.0)));
  EXPECT_TRUE(starts_in(inverse, Vec3(0.9)));
}

TEST(Start, AsksTheBoxOfAClipAndNotTheClip) {
  Object plane = object_of(make_plane(Vec3(0.0, 1.0, 0.0), 0.0));
  plane.cramped = true;
  plane.extras.change().clipped_by = list({object_of(make_sphere(Vec3(0.0), 1.0))});
  EXPECT_TRUE(starts_in(plane, Vec3(-0.9)));
  EXPECT_FALSE(starts_in(plane, Vec3(0.0, -1.5, 0.0)));
}

TEST(Start, OfRaysFromManyPlacesIsAskedOfWhatMayHoldThem) {
  SceneBuilder builder;
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  Object glass = object_of(make_sphere(Vec3(0.0), 1.0));
  glass.extras.change().interior = Interior();
  Object water = object_of(make_plane(Vec3(0.0, 1.0, 0.0), 0.0));
  water.extras.change().interior = Interior();
  for (const Object& object : {glass, water, object_of(make_sphere(Vec3(9.0), 1.0))}) builder.add(object, texture);
  const auto scene = builder.build();
  const Box3 origins(Vec3(-2.0), Vec3(2.0));
  MediumTable media;
  const StartMedium medium(*scene, media, origins);
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = Vec3(i % 5, i / 5 % 5, i / 25) - Vec3(2.0, 2.0, 3.5) * 0.9;
    if (!origins.intersects(point)) continue;
    EXPECT_EQ(medium.of(point), medium_at(*scene, media, point)) << point;
  }
  EXPECT_FALSE(may_hold_start(scene->solids[2], origins));
}

}  // namespace
}  // namespace firstlight::render
