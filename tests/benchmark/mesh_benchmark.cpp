// How long rays take to meet a mesh, in blocks of neighbouring pixels and of rays that go anywhere, and how long its tree
// takes to be built.
#include "render/shape/mesh.h"
#include "render/shape/slots.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace firstlight::render {
namespace {

/// A torus with bumps.
MeshParameters bumpy_torus(std::size_t faces) {
  const auto round = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(faces) / 4.0)), along = 2 * round;
  MeshParameters mesh;
  const auto turn = [](std::uint32_t i, std::uint32_t of) { return 2.0 * std::numbers::pi * i / of; };
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < round; ++j) {
      const double a = turn(i, along), b = turn(j, round);
      const double r =
          0.9 + 0.1 * std::sin(9 * a) * std::cos(6 * b) + 0.03 * std::sin(40 * a + 3 * b) * std::sin(31 * b);
      const double ring = 2.0 + r * std::cos(b);
      mesh.vertices.emplace_back(ring * std::cos(a), r * std::sin(b), ring * std::sin(a));
      const std::uint32_t next_i = (i + 1) % along, next_j = (j + 1) % round;
      const std::uint32_t corner = i * round + j, corner_b = next_i * round + j, corner_c = next_i * round + next_j;
      mesh.faces.push_back({corner, corner_b, corner_c});
      mesh.faces.push_back({corner, corner_c, i * round + next_j});
    }
  }
  return mesh;
}

/// Blocks of eight times eight neighbouring pixels.
std::vector<RayColumns> picture_rays(int size) {
  const Vec3 eye(0.0, 5.0, -9.0);
  std::vector<RayColumns> blocks;
  for (int y = 0; y < size; y += 8) {
    for (int x = 0; x < size; x += 8) {
      RayColumns& rays = blocks.emplace_back();
      for (int i = 0; i < 64; ++i) {
        const double u = (x + i % 8) * 6.0 / size - 3.0, v = (y + i / 8) * 4.0 / size - 2.0;
        rays.origin.set(static_cast<std::size_t>(i), eye);
        rays.direction.set(static_cast<std::size_t>(i), (Vec3(u, 0.2 * v, v) - eye).normalized());
      }
    }
  }
  return blocks;
}

std::vector<RayColumns> scattered_rays(std::size_t count) {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  const auto point = [&] { return Vec3(any(random), any(random), any(random)); };
  std::vector<RayColumns> blocks(count);
  for (RayColumns& rays : blocks) {
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      const Vec3 from = point().normalized() * 4.0;
      rays.origin.set(i, from);
      rays.direction.set(i, (point() - from).normalized());
    }
  }
  return blocks;
}

void meet_all_blocks(benchmark::State& state, const std::vector<RayColumns>& blocks) {
  const ShapePtr mesh = make_mesh(bumpy_torus(static_cast<std::size_t>(state.range(0))));
  Column<double> low, high;
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
    low[i] = 0.0;
    high[i] = 1e7;
  }
  const DepthWindow window{low, high};
  std::int64_t rays = 0, met = 0;
  for (auto _ : state) {
    for (const RayColumns& block : blocks) {
      Slots& slots = Slots::of_thread();
      mesh->meet_block(block, ~std::uint64_t{0}, &window, slots);
      rays += kRaysAtOnce;
      for (std::size_t s = 0; s < slots.size(); ++s) met += __builtin_popcountll(slots[s].rays);
    }
  }
  state.counters["ns a ray"] =
      benchmark::Counter(static_cast<double>(rays) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["met"] = static_cast<double>(met) / static_cast<double>(rays);
}

void neighbouring_rays(benchmark::State& state) { meet_all_blocks(state, picture_rays(800)); }
void rays_anywhere(benchmark::State& state) { meet_all_blocks(state, scattered_rays(2000)); }
void building(benchmark::State& state) {
  const MeshParameters mesh = bumpy_torus(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(make_mesh(mesh));
}

BENCHMARK(neighbouring_rays)->Arg(1'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(rays_anywhere)->Arg(1'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(building)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace firstlight::render
