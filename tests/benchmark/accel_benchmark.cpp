#include "render/accel/accel.h"
#include "render/shape/primitives.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

namespace {

using namespace firstlight::render;

void add(Scene& scene, ShapePtr shape) {
  Part part;
  part.opaque = true;
  scene.parts.push_back(part);
  Solid solid;
  solid.shape = std::move(shape);
  solid.part = static_cast<std::uint32_t>(scene.parts.size() - 1);
  solid.close();
  scene.solids.push_back(solid);
}

/// Nine smaller spheres on each, `levels` deep: 7381 for four levels. [Haines, the standard procedural databases]
void add_flake(Scene& scene, const Vec3& center, double radius, const Vec3& away, int levels) {
  add(scene, make_sphere(center, radius));
  if (levels == 0) return;
  const Vec3 helper = std::abs(away.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 u = away.cross(helper).normalized();
  const Vec3 v = away.cross(u);
  for (int i = 0; i < 9; ++i) {
    const bool low = i < 6;
    const double turn = (low ? i * 60.0 : i * 120.0 + 30.0) * M_PI / 180.0;
    const double lift = low ? 0.0 : 0.8;
    const double flat = std::sqrt(1.0 - lift * lift);
    const Vec3 d = (u * (std::cos(turn) * flat) + v * (std::sin(turn) * flat) + away * lift).normalized();
    add_flake(scene, center + d * (radius * 4.0 / 3.0), radius / 3.0, d, levels - 1);
  }
}

Scene flake_in_a_room() {
  Scene scene;
  add_flake(scene, Vec3(0, 0, 0), 1.0, Vec3(0, 1, 0), 4);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 n(0.0);
    n[axis] = 1.0;
    add(scene, make_plane(n, 4.0));
    add(scene, make_plane(n, -4.0));
  }
  return scene;
}

/// A camera's rays, what reflects from where they end, and the feelers to a light from there: a third each.
struct Rays {
  std::vector<RayQuery> seen;
  std::vector<RayQuery> feelers;
};

Rays mixed_rays(const Accel& accel, int size) {
  Rays rays;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(0.0, 1.0);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Vec3 d(((x + jitter(random)) / size - 0.5) * 1.2, ((y + jitter(random)) / size - 0.5) * 1.2, 1.0);
      rays.seen.push_back({{Vec3(0.3, 0.5, -3.9), d.normalized()}, 1e-4, 1e7, kHiddenFromPrimary});
    }
  }
  std::vector<Hit> hits(rays.seen.size());
  accel.closest(rays.seen, hits);
  const std::size_t primaries = rays.seen.size();
  for (std::size_t i = 0; i < primaries; ++i) {
    if (hits[i].part == kNoIndex) continue;
    const Ray ray = rays.seen[i].ray;
    const Vec3 p = ray.at(hits[i].depth);
    const Vec3 n = hits[i].shape->normal(p, {hits[i].depth, hits[i].shape, hits[i].part, hits[i].face});
    const Vec3 mirrored = (ray.direction - n * (2.0 * n.dot(ray.direction))).normalized();
    rays.seen.push_back({{p, mirrored}, 1e-4, 1e7, kHiddenFromReflection});
    const Vec3 to_light = Vec3(3.5, 3.5, -3.5) - p;
    rays.feelers.push_back({{p, to_light.normalized()}, 1e-3, to_light.length() - 1e-3, kHiddenFromShadow});
  }
  return rays;
}

void MixedRays(benchmark::State& state) {
  const Scene scene = flake_in_a_room();
  const Accel accel(scene);
  const Rays rays = mixed_rays(accel, 512);
  std::vector<Hit> hits(rays.seen.size());
  std::vector<std::uint8_t> blocked(rays.feelers.size());
  for (auto _ : state) {
    accel.closest(rays.seen, hits);
    accel.occluded(rays.feelers, blocked);
    benchmark::DoNotOptimize(hits.data());
    benchmark::DoNotOptimize(blocked.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(hits.size() + blocked.size()));
}
BENCHMARK(MixedRays)->Unit(benchmark::kMillisecond);

void Build(benchmark::State& state) {
  const Scene scene = flake_in_a_room();
  for (auto _ : state) {
    const Accel accel(scene);
    benchmark::DoNotOptimize(&accel);
  }
}
BENCHMARK(Build)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
