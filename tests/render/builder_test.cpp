#include "render/scene/scene_builder.h"

#include "render/shape/primitives.h"
#include "render/texture/patterning.h"

#include <gtest/gtest.h>

#include <chrono>
#include <utility>

namespace firstlight::render {
namespace {

TexturePtr solid_texture(float level) {
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  texture->layers[0].pigment.color.rgb = Rgb(level);
  return texture;
}

TexturePtr patterned_texture() {
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  texture->layers[0].pigment.pattern = PigmentPattern{patterned(PatternKind::checker), {{0.0, {}}, {1.0, {}}}};
  return texture;
}

TexturePtr clear_texture() {
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({});
  texture->layers[0].pigment.color.transmit = 1.0f;
  return texture;
}

const TexturePtr kDefault = solid_texture(0.5f);

Object sphere_at(double x, double radius = 1.0) {
  Object object;
  object.shape = make_sphere({x, 0.0, 0.0}, radius);
  return object;
}

Object light_at(double x) {
  Object object;
  object.kind = Object::Kind::light;
  object.extras.change().light.change().position = {x, 0.0, 0.0};
  return object;
}

Object combined(Object::Kind kind, std::vector<Object> children) {
  Object object;
  object.kind = kind;
  object.children = std::make_shared<const std::vector<Object>>(std::move(children));
  return object;
}

Object union_of(std::vector<Object> children) { return combined(Object::Kind::union_, std::move(children)); }
Object intersection_of(std::vector<Object> children) {
  return combined(Object::Kind::intersection, std::move(children));
}

std::shared_ptr<const std::vector<Object>> list(std::vector<Object> objects) {
  return std::make_shared<const std::vector<Object>>(std::move(objects));
}

std::unique_ptr<const Scene> scene_of(std::vector<Object> objects) {
  SceneBuilder builder;
  for (Object& object : objects) builder.add(object, kDefault);
  return builder.build();
}

double middle_x(const Solid& solid) { return solid.box().center().x; }

TEST(SceneBuilder, DissolvesUnionsInTheOrderOfTheirMembers) {
  const auto scene = scene_of({sphere_at(1), union_of({sphere_at(2), union_of({sphere_at(3), sphere_at(4)})})});
  ASSERT_EQ(scene->solids.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(scene->solids[i].kind, Solid::Kind::shape);
    EXPECT_NEAR(middle_x(scene->solids[i]), i + 1.0, 1e-6);
  }
}

TEST(SceneBuilder, KeepsAUnionThatIsNotToBeSplit) {
  Object whole = union_of({sphere_at(1), sphere_at(2)});
  whole.split_union = false;
  const auto scene = scene_of({whole});
  ASSERT_EQ(scene->solids.size(), 1u);
  EXPECT_EQ(scene->solids[0].kind, Solid::Kind::union_);
}

TEST(SceneBuilder, GivesCombinationsTheBoxThatPovRayHasOfThem) {
  // Its corners are turned, not its members: a box about the box.
  Object turned = intersection_of({sphere_at(0), sphere_at(0)});
  place(turned, Transform::rotation(Vec3(0.0, 0.0, 45.0)));
  EXPECT_NEAR(scene_of({turned})->solids[0].extent().length[0], 2.0 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(scene_of({sphere_at(0)})->solids[0].extent().length[0], 2.0, 1e-5);
}

TEST(SceneBuilder, KeepsAUnionThatIsClippedOrBounded) {
  Object clipped = union_of({sphere_at(1), sphere_at(2)});
  clipped.extras.change().clipped_by = list({sphere_at(0, 9)});
  Object bounded = union_of({sphere_at(1), sphere_at(2)});
  bounded.extras.change().bounded_by = list({sphere_at(0, 9)});
  const auto scene = scene_of({clipped, bounded});
  ASSERT_EQ(scene->solids.size(), 2u);
  EXPECT_EQ(scene->solids[0].kind, Solid::Kind::union_);
  EXPECT_EQ(scene->solids[0].members().size(), 2u);
  EXPECT_EQ(scene->solids[0].clips().size(), 1u);
  EXPECT_TRUE(scene->solids[0].bounds().empty());
  EXPECT_EQ(scene->solids[1].bounds().size(), 1u);
  EXPECT_EQ(scene->parts.size(), 4u) << "clips and bounds are not seen, so they have no parts";
}

TEST(SceneBuilder, BoundsThatAreClipsServeAsBoth) {
  Object from_clips = sphere_at(1);
  from_clips.extras.change().clipped_by = list({sphere_at(0, 9)});
  from_clips.extras.change().bounds_are_clips = true;
  Object from_bounds = intersection_of({sphere_at(1), sphere_at(2)});
  from_bounds.extras.change().bounded_by = list({sphere_at(0, 9)});
  from_bounds.extras.change().bounds_are_clips = true;
  const auto scene = scene_of({intersection_of({from_clips}), from_bounds});
  EXPECT_EQ(scene->solids[0].members()[0].clips().size(), 1u);
  EXPECT_EQ(scene->solids[0].members()[0].bounds().size(), 1u);
  EXPECT_EQ(scene->solids[1].clips().size(), 1u);
  EXPECT_EQ(scene->solids[1].bounds().size(), 1u);
}

TEST(SceneBuilder, DropsTheBoundsOfASimpleShapeOutsideCombinations) {
  Object shape = sphere_at(1);
  shape.extras.change().bounded_by = list({sphere_at(50)});
  const auto scene = scene_of({shape, union_of({shape}), intersection_of({shape, sphere_at(0, 9)})});
  EXPECT_TRUE(scene->solids[0].bounds().empty());
  EXPECT_TRUE(scene->solids[1].bounds().empty());
  EXPECT_EQ(scene->solids[2].members()[0].bounds().size(), 1u);
}

TEST(SceneBuilder, ComposesPlacementsOnTheWayDown) {
  Object inner = union_of({sphere_at(1)});
  inner.placement = Transform::translation({10.0, 0.0, 0.0});
  Object outer = union_of({inner, light_at(1)});
  outer.placement = Transform::scaling({2.0, 2.0, 2.0});
  const auto scene = scene_of({outer});
  EXPECT_NEAR(middle_x(scene->solids[0]), 22.0, 1e-6);
  EXPECT_DOUBLE_EQ(scene->lights[0].position.x, 2.0);
}

TEST(SceneBuilder, PlacesClipsWithTheirObject) {
  Object object = sphere_at(0);
  object.extras.change().clipped_by = list({sphere_at(1)});
  object.placement = Transform::translation({5.0, 0.0, 0.0});
  const auto scene = scene_of({object});
  EXPECT_TRUE(scene->solids[0].clips()[0].inside({6.9, 0.0, 0.0}));
  EXPECT_FALSE(scene->solids[0].clips()[0].inside({4.9, 0.0, 0.0}));
}

TEST(SceneBuilder, LightsKeepTheOrderOfTheScene) {
  const auto scene =
      scene_of({light_at(1), intersection_of({sphere_at(0), light_at(2)}), union_of({light_at(3)}), light_at(4)});
  ASSERT_EQ(scene->lights.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(scene->lights[i].position.x, i + 1.0);
  EXPECT_EQ(scene->solids.size(), 1u);
  EXPECT_EQ(scene->solids[0].members().size(), 1u) << "a light is no member of a combination";
}

TEST(SceneBuilder, ChildrenWithoutATextureTakeTheirParents) {
  Object own = sphere_at(1);
  own.texture = patterned_texture();
  own.texture_placement = Transform::translation({1.0, 0.0, 0.0});
  Object parent = union_of({own, sphere_at(2)});
  parent.texture = patterned_texture();
  parent.placement = Transform::translation({0.0, 7.0, 0.0});
  parent.texture_placement = Transform::translation({0.0, 3.0, 0.0});
  const auto scene = scene_of({parent, sphere_at(3)});
  const auto look = [&](int part) { return scene->textures[scene->parts[part].texture]; };
  EXPECT_EQ(look(0).texture, own.texture);
  EXPECT_EQ(look(0).to_texture.point({1.0, 7.0, 0.0}), Vec3(0.0, 0.0, 0.0)) << "moves with the parent";
  EXPECT_EQ(look(1).texture, parent.texture);
  EXPECT_EQ(look(1).to_texture.point({0.0, 3.0, 0.0}), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(look(2).texture, kDefault);
}

TEST(SceneBuilder, InteriorTextureIsInheritedOnItsOwn) {
  Object child = sphere_at(1);
  child.texture = solid_texture(0.1f);
  Object parent = union_of({child});
  parent.texture = solid_texture(0.2f);
  parent.extras.change().interior_texture = solid_texture(0.3f);
  const auto scene = scene_of({parent, sphere_at(2)});
  EXPECT_EQ(scene->textures[scene->parts[0].interior_texture].texture, parent.extras->interior_texture);
  EXPECT_EQ(scene->parts[1].interior_texture, kNoIndex);
}

TEST(SceneBuilder, SharesOneEntryAmongEqualPlacesOfATexture) {
  Object plain = sphere_at(1);
  plain.texture = solid_texture(0.7f);
  Object patterned = sphere_at(1);
  patterned.texture = patterned_texture();
  std::vector<Object> objects;
  for (double x : {0.0, 1.0, 0.0}) {
    for (Object object : {plain, patterned}) {
      place(object, Transform::translation({x, 0.0, 0.0}));
      objects.push_back(object);
    }
  }
  const auto scene = scene_of(objects);
  EXPECT_EQ(scene->textures.size(), 3u) << "the plain one once, the patterned one in two places";
  EXPECT_EQ(scene->parts[1].texture, scene->parts[5].texture);
  EXPECT_NE(scene->parts[1].texture, scene->parts[3].texture);
}

TEST(SceneBuilder, OneObjectIsOnePieceOfMatter) {
  Object glass = sphere_at(2);
  glass.extras.change().interior = Interior{.ior = 1.5};
  Object parent = union_of({sphere_at(1), glass, union_of({sphere_at(3)})});
  parent.extras.change().interior = Interior{.ior = 1.3};
  const auto scene = scene_of({parent, sphere_at(4), sphere_at(5)});
  const auto& parts = scene->parts;
  EXPECT_EQ(parts[0].interior, parts[2].interior);
  EXPECT_NE(parts[0].interior, parts[1].interior);
  EXPECT_NE(parts[3].interior, parts[4].interior);
  EXPECT_EQ(scene->interiors[parts[0].interior]->ior, 1.3);
  EXPECT_EQ(scene->interiors[parts[1].interior]->ior, 1.5);
  EXPECT_EQ(scene->interiors[parts[3].interior]->ior, 1.0);
}

TEST(SceneBuilder, MatterThatNothingIsSaidOfIsKeptOnce) {
  SceneBuilder builder;
  builder.settings().atmosphere_ior = 1.2;
  for (int i = 0; i < 3; ++i) builder.add(sphere_at(i), kDefault);
  builder.settings().atmosphere_ior = 1.3;
  builder.add(sphere_at(3), kDefault);
  const auto scene = builder.build();
  ASSERT_EQ(scene->interiors.size(), 4u);
  EXPECT_TRUE(scene->interiors[0].is_same(scene->interiors[2]));
  EXPECT_EQ(scene->interiors[2]->ior, 1.2);
  EXPECT_EQ(scene->interiors[3]->ior, 1.3);
}

TEST(SceneBuilder, FindsEachOfManyTexturesAgain) {
  std::vector<Object> objects;
  std::vector<TexturePtr> textures;
  for (int i = 0; i < 500; ++i) textures.push_back(i % 2 == 0 ? solid_texture(0.5f) : patterned_texture());
  for (int i = 0; i < 1500; ++i) {
    Object object = sphere_at(i);
    object.texture = textures[i % 500];
    object.texture_placement = Transform::translation({i % 1000 / 500 * 1.0, 0.0, 0.0});
    objects.push_back(object);
  }
  const auto scene = scene_of(objects);
  EXPECT_EQ(scene->textures.size(), 750u) << "250 that look the same everywhere, 250 in two places";
  for (int i = 0; i < 1500; ++i) {
    const PlacedTexture& placed = scene->textures[scene->parts[i].texture];
    EXPECT_EQ(placed.texture, textures[i % 500]);
    if (i % 2 == 1) {
      EXPECT_EQ(placed.to_texture.point(Vec3(0.0)).x, i % 1000 < 500 ? 0.0 : -1.0);
    }
  }
}

TEST(SceneBuilder, CopiesOfADeclaredObjectAreDifferentMatter) {
  Object glass = sphere_at(1);
  glass.extras.change().interior = Interior();
  const auto scene = scene_of({glass, glass});
  EXPECT_NE(scene->parts[0].interior, scene->parts[1].interior);
}

TEST(SceneBuilder, RefractionInTheFinishGoesToTheInterior) {
  auto old = std::make_shared<Texture>();
  old->layers = std::vector<TextureLayer>(2);
  old->layers[0].finish.change().legacy_ior = 1.4;
  old->layers[0].finish.change().legacy_refraction = 0.8;
  old->layers[1].finish.change().legacy_ior = 9.0;
  Object object = sphere_at(1);
  object.texture = old;
  const auto scene = scene_of({object});
  EXPECT_EQ(scene->interiors[scene->parts[0].interior]->ior, 1.4);
  EXPECT_EQ(scene->interiors[scene->parts[0].interior]->refraction_scale, 0.8);
}

TEST(SceneBuilder, IorOfZeroIsThatOfTheSurroundings) {
  Object object = sphere_at(1);
  object.extras.change().interior = Interior{.ior = 0.0};
  SceneBuilder builder;
  builder.settings().atmosphere_ior = 1.2;
  builder.add(object, kDefault);
  builder.add(sphere_at(2), kDefault);
  const auto scene = builder.build();
  EXPECT_EQ(scene->interiors[scene->parts[0].interior]->ior, 1.2);
  EXPECT_EQ(scene->interiors[scene->parts[1].interior]->ior, 1.2);
}

TEST(SceneBuilder, FlagsReachTheLeaves) {
  Object child = sphere_at(1);
  child.no_image = true;
  Object parent = union_of({child, sphere_at(2)});
  parent.no_shadow = true;
  parent.double_illuminate = true;
  Object mirrored = sphere_at(3);
  mirrored.no_reflection = true;
  const auto scene = scene_of({parent, mirrored});
  EXPECT_EQ(scene->solids[0].hidden_from, kHiddenFromPrimary | kHiddenFromShadow);
  EXPECT_EQ(scene->solids[1].hidden_from, kHiddenFromShadow);
  EXPECT_EQ(scene->solids[2].hidden_from, kHiddenFromReflection);
  EXPECT_TRUE(scene->parts[0].double_illuminate);
  EXPECT_FALSE(scene->parts[2].double_illuminate);
}

TEST(SceneBuilder, ComplementOfAUnionIsTheIntersectionOfComplements) {
  Object object = union_of({sphere_at(0), sphere_at(1)});
  invert(object);
  const auto scene = scene_of({object});
  ASSERT_EQ(scene->solids.size(), 1u);
  EXPECT_EQ(scene->solids[0].kind, Solid::Kind::intersection);
  EXPECT_TRUE(scene->parts[0].inverted);
  EXPECT_FALSE(scene->solids[0].inside({0.5, 0.0, 0.0}));
  EXPECT_TRUE(scene->solids[0].inside({5.0, 0.0, 0.0}));
}

TEST(SceneBuilder, ComplementOfAnIntersectionIsAMerge) {
  Object inner = intersection_of({sphere_at(0), sphere_at(1)});
  invert(inner);
  const auto scene = scene_of({intersection_of({sphere_at(0, 3), inner})});
  const Solid& solid = scene->solids[0];
  EXPECT_EQ(solid.members()[1].kind, Solid::Kind::merge);
  EXPECT_FALSE(solid.inside({0.5, 0.0, 0.0}));
  EXPECT_TRUE(solid.inside({-0.5, 0.0, 0.0}));
}

TEST(SceneBuilder, InvertedTwiceIsAsBefore) {
  Object child = sphere_at(0);
  invert(child);
  Object parent = intersection_of({child});
  invert(parent);
  const auto scene = scene_of({parent});
  EXPECT_FALSE(scene->parts[0].inverted);
  EXPECT_TRUE(scene->solids[0].inside({0.0, 0.0, 0.0}));
}

TEST(SceneBuilder, PartsAreOpaqueOnlyWhenBothSidesAre) {
  Object opaque = sphere_at(1);
  Object clear = sphere_at(2);
  clear.texture = clear_texture();
  Object clear_inside = sphere_at(3);
  clear_inside.texture = solid_texture(1.0f);
  clear_inside.extras.change().interior_texture = clear_texture();
  const auto scene = scene_of({opaque, clear, clear_inside});
  EXPECT_TRUE(scene->parts[0].opaque);
  EXPECT_FALSE(scene->parts[1].opaque);
  EXPECT_FALSE(scene->parts[2].opaque);
}

TEST(SceneBuilder, EmptyGroupsVanish) {
  Object nothing;
  nothing.kind = Object::Kind::union_;
  SceneBuilder builder;
  builder.add(nothing, kDefault);
  builder.add(union_of({}), kDefault);
  builder.add(intersection_of({union_of({})}), kDefault);
  builder.add(light_at(1), kDefault);
  EXPECT_EQ(builder.object_count(), 0u);
  builder.add(sphere_at(1), kDefault);
  EXPECT_EQ(builder.object_count(), 1u);
}

TEST(SceneBuilder, KeepsTheCameraAndTheNames) {
  SceneBuilder builder;
  EXPECT_FALSE(builder.has_camera());
  Camera camera;
  camera.location = {1.0, 2.0, 3.0};
  builder.set_camera(camera);
  EXPECT_TRUE(builder.has_camera());
  Object named = sphere_at(1);
  named.extras.change().names = {"Ball"};
  builder.add(named, kDefault);
  const auto scene = builder.build();
  EXPECT_EQ(scene->camera.location, camera.location);
  EXPECT_EQ(scene->objects[scene->parts[0].object].names, std::vector<std::string>{"Ball"});
}

TEST(SceneBuilder, BuildsHundredThousandObjectsInUnderASecond) {
  Object group = union_of(std::vector<Object>(100, sphere_at(1)));
  group.texture = patterned_texture();
  const auto start = std::chrono::steady_clock::now();
  SceneBuilder builder;
  for (int i = 0; i < 1000; ++i) {
    Object copy = group;
    place(copy, Transform::translation({0.1 * i, 0.0, 0.0}));
    builder.add(std::move(copy), kDefault);
  }
  const auto scene = builder.build();
  [[maybe_unused]] const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(scene->solids.size(), 100000u);
  EXPECT_EQ(scene->textures.size(), 1000u);
#ifdef NDEBUG
  EXPECT_LT(taken.count(), 1.0);
#endif
}

TEST(Object, TexturesMoveWithTheirObjectFromWhenTheyWereGiven) {
  Object object = sphere_at(0);
  place(object, Transform::translation({1.0, 0.0, 0.0}));
  object.texture = patterned_texture();
  place(object, Transform::translation({0.0, 1.0, 0.0}));
  EXPECT_EQ(object.placement.point({0.0, 0.0, 0.0}), Vec3(1.0, 1.0, 0.0));
  EXPECT_EQ(object.texture_placement.point({0.0, 0.0, 0.0}), Vec3(0.0, 1.0, 0.0));
}

}  // namespace
}  // namespace firstlight::render
