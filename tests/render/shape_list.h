#pragma once

#include "render/function/internal.h"
#include "render/function/program.h"
#include "render/math/transform.h"
#include "render/shape/bicubic_patch.h"
#include "render/shape/blob.h"
#include "render/shape/height_field.h"
#include "render/shape/isosurface.h"
#include "render/shape/julia_fractal.h"
#include "render/shape/lathe.h"
#include "render/shape/mesh.h"
#include "render/shape/ovus.h"
#include "render/shape/parametric.h"
#include "render/shape/poly.h"
#include "render/shape/polygon.h"
#include "render/shape/primitives.h"
#include "render/shape/prism.h"
#include "render/shape/quadric.h"
#include "render/shape/slots.h"
#include "render/shape/sor.h"
#include "render/shape/sphere_sweep.h"
#include "render/shape/superellipsoid.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::render {

struct NamedShape {
  std::string name;
  ShapePtr shape;
};

inline ShapePtr make_poly_of(int order, const std::vector<std::pair<std::array<int, 3>, double>>& terms) {
  PolyParameters poly;
  poly.order = order;
  poly.coefficients.assign(PolyParameters::coefficient_count(order), 0.0);
  for (const auto& [powers, number] : terms) {
    poly.coefficients[PolyParameters::place(order, powers[0], powers[1], powers[2])] = number;
  }
  return make_poly(poly);
}

/// Shapes about the origin that rays meet where polynomials are 0.
inline std::vector<NamedShape> shapes_of_equations() {
  using Spline = ProfileSpline;
  using Kind = BlobParameters::Component::Kind;
  const Transform turned = Transform::scaling(Vec3(1.2, 0.8, 1.0)).then(Transform::rotation(Vec3(50.0, 10.0, 30.0)));
  const std::vector<Vec2> ring = {{-0.9, -0.8}, {0.8, -0.9}, {1.0, 0.7}, {-0.2, 0.3}, {-0.9, 0.9}, {-0.9, -0.8}};
  std::vector<Vec2> around = ring;
  around.push_back(ring[1]);
  around.push_back(ring[2]);
  const std::vector<Vec2> bowl = {{0.3, -1.0}, {0.9, -0.6}, {0.4, 0.1}, {0.8, 0.8}, {0.2, 1.1}, {0.1, 1.3}};
  const std::vector<Vec2> bezier = {{0.2, -1.0}, {1.4, -0.5}, {0.1, 0.2}, {0.9, 0.9},
                                    {0.9, 0.9},  {0.5, 1.0},  {0.3, 0.8}, {0.2, -1.0}};
  BlobParameters few;
  few.threshold = 0.4;
  few.components = {{Kind::sphere, Vec3(0.3, 0.1, 0.0), Vec3(0.0), 1.1, 1.0, Transform(), 0},
                    {Kind::cylinder, Vec3(-0.9, -0.2, 0.1), Vec3(0.8, 0.5, -0.3), 0.6, 0.9, turned, 0},
                    {Kind::sphere, Vec3(-0.2, 0.4, 0.2), Vec3(0.0), 0.7, -0.6, Transform(), 0}};
  BlobParameters many = few;
  for (int i = 0; i < 40; ++i) {
    const Vec3 at(std::sin(1.7 * i), std::sin(2.9 * i + 1.0), std::sin(0.7 * i + 2.0));
    many.components.push_back({Kind::sphere, at, Vec3(0.0), 0.5, i % 5 == 0 ? -0.5 : 1.0, Transform(), 0});
  }
  return {
      {"negative torus", make_torus(-0.8, 0.4)},
      {"cubic", make_poly_of(3, {{{3, 0, 0}, 1.0}, {{0, 2, 0}, 1.0}, {{0, 0, 2}, 0.7}, {{1, 0, 0}, -0.6}})},
      {"quartic", make_poly_of(4, {{{4, 0, 0}, 1.0}, {{0, 4, 0}, 1.0}, {{0, 0, 2}, 0.8}, {{0, 0, 0}, -0.6}})},
      {"cubic as sextic", make_poly_of(6, {{{2, 1, 0}, 1.0}, {{0, 0, 2}, 1.0}, {{0, 0, 0}, -0.3}})},
      {"of order 8", make_poly_of(8, {{{8, 0, 0}, 1.0}, {{0, 6, 0}, 1.0}, {{0, 0, 4}, 1.0}, {{0, 0, 0}, -0.7}})},
      {"linear lathe", make_lathe({Spline::linear, bowl})},
      {"quadratic lathe", make_lathe({Spline::quadratic, bowl})},
      {"cubic lathe", make_lathe({Spline::cubic, bowl})->placed(turned)},
      {"bezier lathe", make_lathe({Spline::bezier, bezier})},
      {"sor", make_sor({bowl, false})},
      {"open sor", make_sor({bowl, true})->placed(turned)},
      {"linear prism", make_prism({Spline::linear, PrismParameters::Sweep::linear, -0.7, 0.8, ring, false})},
      {"conic prism", make_prism({Spline::linear, PrismParameters::Sweep::conic, 0.1, 1.3, ring, false})},
      {"cubic prism", make_prism({Spline::cubic, PrismParameters::Sweep::linear, -0.7, 0.8, around, true})},
      {"bezier prism",
       make_prism({Spline::bezier, PrismParameters::Sweep::linear, -0.7, 0.8, bezier, false})->placed(turned)},
      {"blob", make_blob(few)},
      {"blob of many", make_blob(many)->placed(turned)},
      {"ovus", make_ovus(0.9, 0.6)},
  };
}

/// Balls about the origin that grow and shrink along a curve, whose parts overlap.
inline ShapePtr swept_balls(SphereSweepParameters::Spline spline, int count) {
  SphereSweepParameters sweep;
  sweep.spline = spline;
  for (int i = 0; i < count; ++i) {
    const double a = 0.9 * i;
    sweep.balls.push_back({Vec3(std::cos(a), 1.6 * i / (count - 1) - 0.8, std::sin(a)), 0.3 + 0.1 * std::sin(3.0 * a)});
  }
  return make_sphere_sweep(sweep);
}

/// A landscape of hills about the origin, of 23 times 37 points.
inline ShapePtr hilly_height_field() {
  HeightFieldParameters field;
  field.columns = 23;
  field.rows = 37;
  for (int z = 0; z < field.rows; ++z) {
    for (int x = 0; x < field.columns; ++x) {
      field.heights.push_back(static_cast<std::uint16_t>(30000.0 + 20000.0 * std::sin(0.7 * x) * std::cos(0.4 * z)));
    }
  }
  field.water_level = 0.2;
  return make_height_field(field)->placed(
      Transform::translation(Vec3(-0.5)).then(Transform::scaling(Vec3(2.6, 1.8, 2.4))));
}

/// A ball of some hundred triangles about the origin, with an inside.
inline ShapePtr ball_of_triangles() {
  MeshParameters mesh;
  constexpr std::uint32_t kAround = 24, kUp = 12;
  for (std::uint32_t j = 0; j <= kUp; ++j) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double a = 6.283185307 * i / kAround, b = 3.141592654 * j / kUp;
      mesh.vertices.emplace_back(std::sin(b) * std::cos(a), 1.1 * std::cos(b), 0.9 * std::sin(b) * std::sin(a));
    }
  }
  for (std::uint32_t j = 0; j < kUp; ++j) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t next = (i + 1) % kAround, low = j * kAround, high = low + kAround;
      mesh.faces.push_back({low + i, low + next, high + i});
      mesh.faces.push_back({low + next, high + next, high + i});
    }
  }
  mesh.inside_vector = Vec3(0.1, 0.9, 0.2).normalized();
  return make_mesh(mesh);
}

inline ShapePtr bent_patch() {
  BicubicPatchParameters patch;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double u = static_cast<double>(i) - 1.5, v = static_cast<double>(j) - 1.5;
      patch.points[i][j] = Vec3(u, 0.6 * u * v + 0.3 * v * v - 0.4, v);
    }
  }
  patch.u_steps = patch.v_steps = 3;
  return make_bicubic_patch(patch);
}

inline ShapePtr julia_of(JuliaFractalParameters::Algebra algebra, JuliaFunction function, const Vec4& parameter) {
  JuliaFractalParameters julia;
  julia.algebra = algebra;
  julia.function = function;
  julia.parameter = parameter;
  julia.most_iterations = 6;
  julia.precision = 6.0;
  julia.exponent = {2.5, 0.3};
  return make_julia_fractal(julia);
}

/// y - 0.3 sin(7 x): with a gradient of 1.1 a ray may miss some of it.
inline IsosurfaceParameters waves() {
  IsosurfaceParameters parameters;
  parameters.function = std::make_shared<Program>(std::vector<Instruction>{{Operation::parameter, 0, 1, 0.0},
                                                                           {Operation::parameter, 0, 0, 0.0},
                                                                           {Operation::multiply_constant, 0, 0, 7.0},
                                                                           {Operation::sine, 0, 0, 0.0},
                                                                           {Operation::multiply_constant, 0, 0, 0.3},
                                                                           {Operation::subtract, 0, 0, 0.0}},
                                                  3);
  return parameters;
}
inline ShapePtr open_waves() {
  IsosurfaceParameters parameters = waves();
  parameters.container = ContainerSphere{Vec3(0.1, 0.0, 0.0), 1.2};
  parameters.open = true;
  parameters.max_gradient = 2.5;
  parameters.max_trace = IsosurfaceParameters::kMostTraces;
  return make_isosurface(parameters);
}
inline ShapePtr noisy_ball() {
  IsosurfaceParameters parameters;
  parameters.function = make_internal(76);
  parameters.threshold = 0.5;
  parameters.evaluate = std::array<double, 3>{3.0, 1.2, 0.95};
  parameters.max_trace = 3;
  return make_isosurface(parameters);
}
inline ShapePtr curved_sheet() {
  const auto argument = [](std::uint16_t index, const std::vector<Instruction>& then) {
    std::vector<Instruction> instructions{{Operation::parameter, 0, index, 0.0}};
    instructions.insert(instructions.end(), then.begin(), then.end());
    return std::make_shared<Program>(instructions, 3);
  };
  ParametricParameters parameters;
  parameters.functions = {argument(0, {}), argument(1, {{Operation::sine, 0, 0, 0.0}}),
                          argument(0, {{Operation::square, 0, 0, 0.0}})};
  parameters.low = Vec2(-1.0, -1.0);
  parameters.max_gradient = 2.0;
  parameters.accuracy = 0.01;
  return make_parametric(parameters);
}

/// Shapes about the origin whose formulas are over lanes, and some whose are not.
inline std::vector<NamedShape> shapes_of_all_kinds() {
  const Transform turned = Transform::scaling(Vec3(1.3, 0.7, 1.0))
                               .then(Transform::rotation(Vec3(20.0, 30.0, 40.0)))
                               .then(Transform::translation(Vec3(0.1, -0.2, 0.3)));
  QuadricParameters paraboloid;
  paraboloid.square = Vec3(1.0, 0.0, 2.0);
  paraboloid.linear = Vec3(0.0, -1.0, 0.0);
  paraboloid.constant = -0.3;
  const Vec3 a(-1.0, -0.8, 0.1), b(1.1, -0.5, -0.2), c(0.1, 1.2, 0.3);
  std::vector<NamedShape> shapes{
      {"plane", make_plane(Vec3(0.2, 1.0, 0.1), 0.3)},
      {"axial plane", make_plane(Vec3(0.0, 1.0, 0.0), -0.5)},
      {"sphere", make_sphere(Vec3(0.2, 0.0, -0.1), 1.1)},
      {"ellipsoid", make_sphere(Vec3(0.2, 0.0, -0.1), 1.1)->placed(turned)},
      {"box", make_box(Vec3(-1.0, -0.5, -0.7), Vec3(0.8, 1.0, 0.5))},
      {"turned box", make_box(Vec3(-1.0, -0.5, -0.7), Vec3(0.8, 1.0, 0.5))->placed(turned)},
      {"cylinder", make_cylinder(Vec3(0.0, -1.0, 0.1), Vec3(0.3, 1.0, 0.0), 0.8, false)},
      {"open cylinder", make_cylinder(Vec3(0.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0), 0.8, true)->placed(turned)},
      {"cone", make_cone(Vec3(0.0, -1.0, 0.1), 1.2, Vec3(0.3, 1.0, 0.0), 0.4, false)},
      {"open cone", make_cone(Vec3(0.0, -1.0, 0.0), 1.0, Vec3(0.0, 1.0, 0.0), 0.0, true)},
      {"disc", make_disc(Vec3(0.0, 0.1, 0.0), Vec3(0.3, 1.0, 0.2), 1.4, 0.3)},
      {"triangle", make_triangle(a, b, c)},
      {"smooth triangle",
       make_smooth_triangle(a, Vec3(0.1, 0.0, -1.0), b, Vec3(0.0, 0.2, -1.0), c, Vec3(0.0, 0.0, -1.0))},
      {"polygon with a hole",
       make_polygon({Vec3(-1, -1, 0), Vec3(1, -1, 0.2), Vec3(1, 1, 0.2), Vec3(-1, 1, 0), Vec3(-1, -1, 0),
                     Vec3(-0.5, -0.5, 0.05), Vec3(0.5, -0.5, 0.15), Vec3(-0.5, 0.5, 0.05), Vec3(-0.5, -0.5, 0.05)})},
      {"quadric", make_quadric(paraboloid)},
      {"turned quadric", make_quadric(paraboloid)->placed(turned)},
      {"torus", make_torus(0.9, 0.3)},
      {"superellipsoid", make_superellipsoid(0.3, 0.7)},
      {"turned superellipsoid", make_superellipsoid(1.2, 0.2)->placed(turned)},
      {"pinched superellipsoid", make_superellipsoid(0.5, 3.0)},
      {"linear sphere sweep", swept_balls(SphereSweepParameters::Spline::linear, 4)},
      {"cubic sphere sweep", swept_balls(SphereSweepParameters::Spline::cubic, 6)->placed(turned)},
      {"sphere sweep of many", swept_balls(SphereSweepParameters::Spline::b_spline, 14)},
      {"height field", hilly_height_field()},
      {"turned height field", hilly_height_field()->placed(turned)},
      {"mesh", ball_of_triangles()},
      {"turned mesh", ball_of_triangles()->placed(turned)},
      {"bicubic patch", bent_patch()},
      {"isosurface", make_isosurface(waves())},
      {"open isosurface", open_waves()->placed(turned)},
      {"isosurface that learns its gradient", noisy_ball()},
      {"parametric surface", curved_sheet()},
  };
  for (NamedShape& shape : shapes_of_equations()) shapes.push_back(std::move(shape));
  const std::size_t count = shapes.size();
  for (std::size_t i = 0; i < count; ++i) shapes.push_back({"inverse " + shapes[i].name, shapes[i].shape->inverted()});
  return shapes;
}

/// And Julia sets, of which the nearest crossing asked for alone is the first, even if it is too near to count.
inline std::vector<NamedShape> shapes_and_julia_sets() {
  using Algebra = JuliaFractalParameters::Algebra;
  std::vector<NamedShape> shapes = shapes_of_all_kinds();
  const Vec4 near(-0.08, 0.1, -0.8, -0.03), far(0.3, 0.2, 0.1, 0.05);
  shapes.push_back({"julia set of squares", julia_of(Algebra::quaternion, JuliaFunction::square, near)});
  shapes.push_back(
      {"julia set of cubes", julia_of(Algebra::quaternion, JuliaFunction::cube, Vec4(-0.2, 0.6, 0.2, 0.2))});
  constexpr std::pair<const char*, JuliaFunction> kFunctions[] = {
      {"hypercomplex squares", JuliaFunction::square}, {"hypercomplex cubes", JuliaFunction::cube},
      {"reciprocals", JuliaFunction::reciprocal},      {"sines", JuliaFunction::sine},
      {"arc tangents", JuliaFunction::arc_tangent},    {"powers", JuliaFunction::power}};
  for (const auto& [name, function] : kFunctions) {
    shapes.push_back({std::string("julia set of ") + name, julia_of(Algebra::hypercomplex, function, far)});
  }
  return shapes;
}

/// Rays from the points towards places about the origin, which depend on the point alone.
inline RayColumns rays_from(const Columns3<double>& points, std::size_t count) {
  RayColumns rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = points.vector(i);
    const auto scattered = [](double x) { return 2.4 * (x - std::floor(x)) - 1.2; };
    const Vec3 aim(scattered(7.3 * p.x + 0.1), scattered(3.7 * p.y + 0.2), scattered(5.1 * p.z + 0.3));
    rays.origin.set(i, p);
    rays.direction.set(i, unit(aim - p));
  }
  return rays;
}

}  // namespace firstlight::render
