#pragma once

#include "render/function/program.h"
#include "render/texture/patterns.h"
#include "render/texture/warp.h"
#include "tests/render/shape_list.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::render {

/// Something that runs over lanes: from points, or rays from there, to three numbers each.
struct Kernel {
  std::string name;
  std::function<void(const Columns3<double>& at, std::size_t count, Columns3<double>& results)> run;
};

class KernelList {
 public:
  KernelList() {
    add_noises();
    add_others();
    add_waves();
    add_warps();
    add_functions();
    add_shapes();
  }
  const std::vector<Kernel>& kernels() const { return kernels_; }

 private:
  /// The pattern's values, and how it tilts if it does so in a way of its own.
  void add(const std::string& name, PatternKind kind, const PatternParameters& parameters = {}, int generator = 2,
           const std::optional<Turbulence>& turbulence = {}) {
    const PatternPtr pattern = make_pattern(kind, {parameters, generator, PatternWorld(), turbulence});
    kernels_.push_back(
        Kernel{name, [pattern](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                 SurfacePoints points;
                 points.size = count;
                 pattern->values(at, points, results.of[0]);
                 for (std::size_t i = 0; i < count; ++i) results.of[1][i] = results.of[2][i] = 0.0;
               }});
    if (!pattern->has_tilt()) return;
    kernels_.push_back(
        Kernel{name + " tilt", [pattern](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                 SurfacePoints points;
                 points.size = count;
                 for (std::size_t i = 0; i < count; ++i) results.set(i, Vec3(0.3, 0.8, -0.2));
                 pattern->tilt({0.7, {}}, at, points, results);
               }});
  }
  void add_noises() {
    const Turbulence turbulence{Vec3(0.4, 0.7, 0.2), 6, 0.5, 2.0};
    for (int generator = 1; generator <= 3; ++generator) {
      const std::string suffix = " " + std::to_string(generator);
      add("bozo" + suffix, PatternKind::bozo, {}, generator);
      add("granite" + suffix, PatternKind::granite, {}, generator);
      add("wrinkles" + suffix, PatternKind::wrinkles, {}, generator);
      add("marble" + suffix, PatternKind::marble, {}, generator, turbulence);
      add("agate" + suffix, PatternKind::agate, AgateParameters(), generator, turbulence);
    }
    add("bumps", PatternKind::bumps);
    add("dents", PatternKind::dents);
    add("wood", PatternKind::wood, {}, 2, turbulence);
    add("wood without turbulence", PatternKind::wood);
    add("spiral1", PatternKind::spiral1, SpiralParameters{3}, 2, turbulence);
    add("spiral2", PatternKind::spiral2, SpiralParameters{2});
  }
  void add_others() {
    FractalParameters fractal;
    fractal.iterations = 60;
    for (int exponent = 2; exponent <= 5; ++exponent) {
      fractal.exponent = exponent;
      for (fractal.exterior_type = 0; fractal.exterior_type <= (exponent == 2 ? 8 : 1); ++fractal.exterior_type) {
        fractal.interior_type = fractal.exterior_type % 7;
        add("mandel " + std::to_string(exponent) + " " + std::to_string(fractal.exterior_type), PatternKind::mandel,
            fractal);
      }
    }
    fractal.exterior_type = 1;
    fractal.exponent = 2;
    fractal.julia = true;
    fractal.start = Vec2(0.353, 0.288);
    add("julia", PatternKind::julia, fractal);
    for (fractal.magnet = 1; fractal.magnet <= 2; ++fractal.magnet) {
      for (const bool julia : {false, true}) {
        fractal.julia = julia;
        add("magnet " + std::to_string(fractal.magnet) + (julia ? " julia" : ""), PatternKind::magnet, fractal);
      }
    }
    for (const double metric : {1.0, 2.0, 3.5}) {
      CrackleParameters crackle;
      crackle.metric = metric;
      crackle.offset = 0.1;
      add("crackle " + std::to_string(metric), PatternKind::crackle, crackle);
      add("facets " + std::to_string(metric), PatternKind::facets, FacetsParameters{0.3, 0.0, metric});
    }
    CrackleParameters solid;
    solid.solid = true;
    add("crackle solid", PatternKind::crackle, solid);
    add("facets coords", PatternKind::facets, FacetsParameters{0.3, 0.5, 2.0});
    add("ripples", PatternKind::ripples);
    add("waves", PatternKind::waves);
    add("boxed", PatternKind::boxed);
    add("cylindrical", PatternKind::cylindrical);
    add("planar", PatternKind::planar);
    add("spherical", PatternKind::spherical);
    add("onion", PatternKind::onion);
    add("leopard", PatternKind::leopard);
    add("radial", PatternKind::radial);
    add("quilted", PatternKind::quilted, QuiltedParameters{0.3, 1.7});
    add("gradient", PatternKind::gradient, GradientParameters{Vec3(1.0, 2.0, -0.5)});
  }
  void add_waves() {
    constexpr std::pair<const char*, WaveForm> kForms[] = {{"ramp", WaveForm::ramp},   {"triangle", WaveForm::triangle},
                                                           {"sine", WaveForm::sine},   {"scallop", WaveForm::scallop},
                                                           {"cubic", WaveForm::cubic}, {"poly", WaveForm::poly}};
    for (const auto& [name, form] : kForms) {
      const Wave wave{form, 1.7, 2.3, 0.4};
      kernels_.push_back(Kernel{std::string("wave ") + name,
                                [wave](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                                  results = at;
                                  shape_all(wave, count, results.of[0]);
                                }});
    }
  }
  void add(const std::string& name, const Warp& warp) {
    Warps warps;
    warps.steps.push_back(warp);
    kernels_.push_back(
        Kernel{"warp " + name, [warps](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                 results = at;
                 warps.to_pattern(results, count);
               }});
  }
  void add_warps() {
    add("transformation",
        Transform::rotation(Vec3(10.0, 20.0, 30.0)).then(Transform::translation(Vec3(1.0, 2.0, 3.0))));
    add("turbulence", Turbulence{Vec3(0.4, 0.7, 0.2), 6, 0.5, 2.0});
    add("repeat", RepeatWarp{0, 0.7, Vec3(0.0, 0.1, 0.2), Vec3(-1.0, 1.0, -1.0)});
    BlackHoleWarp hole{Vec3(0.5), 2.0, 0.8, 2.0, false, 0, {}, {}};
    add("black_hole", hole);
    hole.repeat = Vec3(1.0);
    hole.turbulence = Vec3(0.2);
    add("black_hole repeat", hole);
    add("cylindrical", CylindricalWarp{Vec3(0.0, 0.0, 1.0), 1.5});
    add("spherical", SphericalWarp{Vec3(0.0, 1.0, 0.0), 1.0});
    add("toroidal", ToroidalWarp{Vec3(1.0, 0.0, 0.0), 0.0, 1.2});
    add("planar", PlanarWarp{Vec3(1.0, 0.0, 0.0), 0.3});
    add("cubic", CubicWarp());
  }
  void add_functions() {
    constexpr std::pair<const char*, Operation> kOperations[] = {
        {"acos", Operation::arc_cosine},  {"asin", Operation::arc_sine},
        {"atan", Operation::arc_tangent}, {"cos", Operation::cosine},
        {"exp", Operation::exponential},  {"log", Operation::natural_logarithm},
        {"sin", Operation::sine},         {"tan", Operation::tangent},
        {"pow", Operation::power},        {"atan2", Operation::arc_tangent_of_two}};
    for (const auto& [name, operation] : kOperations) {
      std::vector<Instruction> instructions{{Operation::parameter, 0, 0, 0.0}};
      if (operands(operation) == 2) instructions.push_back({Operation::parameter, 0, 1, 0.0});
      instructions.push_back({operation, 0, 0, 0.0});
      const auto program = std::make_shared<Program>(instructions, 3);
      kernels_.push_back(
          Kernel{std::string("function ") + name,
                 [program](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                   results = at;
                   const double* const from[] = {at.of[0].at.data(), at.of[1].at.data(), at.of[2].at.data()};
                   double* const to = results.of[0].at.data();
                   Evaluation evaluation;
                   program->evaluate_many(from, &to, count, evaluation);
                 }});
    }
  }
  /// The depth of the nearest crossing of rays that go one way, its slot, and whether the ray begins inside.
  void add_shapes() {
    const auto directed = std::make_shared<RayColumns>();
    const auto low = std::make_shared<Column<double>>();
    const auto high = std::make_shared<Column<double>>();
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      directed->direction.set(i, Vec3(-0.48, 0.6, 0.64));
      (*low)[i] = 0.0;
      (*high)[i] = 1e7;
    }
    for (const NamedShape& named : shapes_and_julia_sets()) {
      if (!named.shape->is_over_lanes()) continue;
      const ShapePtr shape = named.shape;
      kernels_.push_back(
          Kernel{named.name, [=](const Columns3<double>& at, std::size_t count, Columns3<double>& results) {
                   directed->origin = at;
                   const std::uint64_t all = ~std::uint64_t{0} >> (kRaysAtOnce - count);
                   Slots& slots = Slots::of_thread();
                   shape->meet_block(*directed, all, nullptr, slots);
                   NearestCrossings nearest;
                   SlotSearch(slots, 0).find(all, DepthWindow{*low, *high}, nearest);
                   results.of[0] = nearest.depth;
                   results.of[1] = nearest.slot;
                   const std::uint64_t inside = shape->inside_block(at, all);
                   for (std::size_t i = 0; i < count; ++i) {
                     results.of[2][i] = static_cast<double>(inside >> i & 1);
                   }
                 }});
    }
  }

  std::vector<Kernel> kernels_;
};

/// Points about the origin, as hits of neighbouring pixels or anywhere, and some at whole and special places.
inline Columns3<double> kernel_points(int block) {
  Columns3<double> at;
  constexpr double kWhole[] = {0.0, 1.0, -1.0, 2.0, -0.5, 0.5, -2.0, 3.0};
  for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
    const double k = static_cast<double>(i), b = block;
    if (block % 3 == 0) {
      at.set(i, Vec3(0.013 * static_cast<double>(i % 8) + 0.37 * b - 2.0, 0.017 * static_cast<double>(i / 8) - 0.21 * b,
                     0.3 * b + 0.01 * k));
    } else if (block % 3 == 1) {
      at.set(i, Vec3(0.731 * k - 20.0 + b, 11.0 - 0.377 * k * b, 0.113 * k * k - 90.0));
    } else {
      at.set(i, Vec3(kWhole[i % 8], kWhole[i / 8 % 8], kWhole[(i + static_cast<std::size_t>(block)) % 8]));
    }
  }
  return at;
}

}  // namespace firstlight::render
