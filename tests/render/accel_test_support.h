#pragma once

#include "render/accel/accel.h"
#include "tests/render/dice.h"
#include "tests/render/solid_test_support.h"

#include <utility>
#include <vector>

// Random solids and rays, and what Accel promises of them.

namespace firstlight::render {

/// The hit that Accel::closest promises, by asking every solid.
inline Hit brute_closest(const Scene& scene, const RayQuery& query) {
  Hit best;
  best.depth = query.max_depth;
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    if ((scene.solids[s].hidden_from & query.hidden_bit) != 0) continue;
    std::vector<Crossing> all;
    scene.solids[s].crossings(query.ray, query.hidden_bit, all);
    for (std::size_t i = all.size(); i-- > 0;) {
      const Crossing& c = all[i];
      if (!(c.depth > query.min_depth && c.depth < best.depth)) continue;
      best = Hit({c.depth, c.shape, c.part, c.face, {}}, static_cast<std::uint32_t>(s));
    }
  }
  return best.part == kNoIndex ? Hit() : best;
}

inline bool brute_occluded(const Scene& scene, const RayQuery& query) {
  for (const Solid& solid : scene.solids) {
    if ((solid.hidden_from & query.hidden_bit) != 0) continue;
    std::vector<Crossing> all;
    solid.crossings(query.ray, query.hidden_bit, all);
    for (const Crossing& c : all) {
      if (scene.parts[c.part].opaque && c.depth > query.min_depth && c.depth < query.max_depth) return true;
    }
  }
  return false;
}

inline ShapePtr random_shape(Dice& dice) {
  const Vec3 p = dice.point(5.0);
  const double r = dice.between(0.05, 0.6);
  switch (dice.below(8)) {
    case 0:
      return make_box(p, p + dice.point(1.0));
    case 1:
      return make_cylinder(p, p + dice.point(1.0), r, dice.below(2) == 0);
    case 2:
      return make_cone(p, r, p + dice.point(1.0), 0.0, false);
    case 3:
      return make_torus(r, 0.3 * r)->placed(Transform::rotation(dice.point(180)).then(Transform::translation(p)));
    case 4:
      return make_triangle(p, p + dice.point(1.0), p + dice.point(1.0));
    case 5:
      return make_disc(p, dice.point(1.0), r, 0.3 * r);
    case 6:
      return make_sphere(Vec3(0.0), r)->placed(Transform::scaling(Vec3(1, 2, 0.5)).then(Transform::translation(p)));
    default:
      return make_sphere(p, r);
  }
}

inline Scene mixed_scene(unsigned seed, int count) {
  Dice dice(seed);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Solid solid = solid_of(random_shape(dice));
    if (dice.below(6) == 0) {
      solid = combined(Solid::Kind::intersection, {solid, solid_of(make_sphere(dice.point(5.0), 3.0)->inverted())});
    }
    if (dice.below(8) == 0) solid = clipped(solid, solid_of(make_plane(dice.point(1.0), 0.2)));
    if (dice.below(8) == 0) solid.hidden_from = static_cast<std::uint8_t>(1 << dice.below(3));
    add_solid(scene, std::move(solid), dice.below(3) != 0);
  }
  add_solid(scene, solid_of(make_plane(Vec3(0, 1, 0), -4.5)));
  add_solid(scene, solid_of(make_plane(Vec3(1, 0.2, 0), 7.0)), false);
  add_solid(scene, solid_of(make_sphere(Vec3(0.0), 1e6)));
  return scene;
}

inline std::vector<RayQuery> random_queries(unsigned seed, int count) {
  Dice dice(seed);
  std::vector<RayQuery> queries;
  for (int i = 0; i < count; ++i) {
    RayQuery q;
    q.ray.origin = dice.point(dice.below(4) == 0 ? 100.0 : 6.0);
    Vec3 d = dice.point(4.0) - q.ray.origin;
    if (dice.below(5) == 0) d[dice.below(3)] = 0.0;
    if (dice.below(10) == 0) {  // along an axis
      const int axis = dice.below(3);
      d = Vec3(0.0);
      d[axis] = dice.below(2) == 0 ? 1.0 : -1.0;
    }
    q.ray.direction = d.normalized();
    q.min_depth = dice.below(4) == 0 ? dice.between(0.0, 5.0) : 1e-4;
    q.max_depth = dice.below(3) == 0 ? dice.between(1.0, 15.0) : 1e7;
    q.hidden_bit = static_cast<std::uint8_t>(dice.below(4) == 0 ? 0 : 1 << dice.below(3));
    queries.push_back(q);
  }
  return queries;
}

}  // namespace firstlight::render
