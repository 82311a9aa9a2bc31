// Shapes that are made of many parts, or given by formulas of any order.

#include "render/shape/bicubic_patch.h"
#include "render/shape/blob.h"
#include "render/shape/height_field.h"
#include "render/shape/lathe.h"
#include "render/shape/mesh.h"
#include "render/shape/ovus.h"
#include "render/shape/poly.h"
#include "render/shape/polygon.h"
#include "render/shape/prism.h"
#include "render/shape/quadric.h"
#include "render/shape/sor.h"
#include "render/shape/superellipsoid.h"
#include "tests/render/shape_test_support.h"
#include "tests/render/textures_at.h"

#include <limits>

namespace firstlight::render {
namespace {

/// Less than check_closed_solid() asks: normals are of unit length, but which way they point is the description's.
void check_surface(const ShapePtr& shape, unsigned seed, double step = 1e-5) {
  RayRain rain(seed);
  const Box3 box = padded(shape->bounds(), 1e-9, 1e-7);
  const ShapePtr complement = shape->inverted();
  int count = 0;
  int sides = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      const Vec3 p = ray.at(crossing.depth);
      const Vec3 n = shape->normal(p, crossing);
      ++count;
      ASSERT_TRUE(box.intersects(p)) << p;
      ASSERT_NEAR(n.length(), 1.0, 1e-9);
      sides += shape->inside(p + n * step) != shape->inside(p - n * step) ? 1 : 0;
    }
    const Vec3 p = rain.point(2.0);
    ASSERT_NE(shape->inside(p), complement->inside(p)) << p;
  }
  ASSERT_GT(count, 200);
  EXPECT_GE(sides, count - count / 200);  // but where the surface has an edge
}

/// The nearest crossing, asked for alone, is that of all.
void check_nearest(const ShapePtr& shape, unsigned seed) {
  RayRain rain(seed);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    const double low = i % 3 == 0 ? 8.0 : 0.0;
    const auto first = [&](const std::vector<Crossing>& all) {
      double depth = std::numeric_limits<double>::infinity();
      for (const Crossing& crossing : all) {
        if (crossing.depth > low) depth = std::min(depth, crossing.depth);
      }
      return depth;
    };
    std::vector<Crossing> found;
    shape->nearest(ray, low, 1e7, found);
    ASSERT_EQ(first(found), first(met(shape, ray)));
  }
}

MeshParameters octahedron() {
  MeshParameters mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const std::uint32_t x : {0u, 1u}) {
    for (const std::uint32_t y : {2u, 3u}) {
      for (const std::uint32_t z : {4u, 5u}) {
        const bool even = (x + y + z) % 2 == 0;
        mesh.faces.push_back(even ? MeshParameters::Corners{x, y, z} : MeshParameters::Corners{x, z, y});
      }
    }
  }
  mesh.inside_vector = Vec3(0.1, 0.9, 0.2).normalized();
  return mesh;
}

TEST(Mesh, OfAnOctahedronIsOne) {
  const ShapePtr shape = make_mesh(octahedron());
  check_surface(shape, 1);
  check_nearest(shape, 2);
  check_placement(shape, uneven_placement(), 3);
  EXPECT_TRUE(shape->inside(Vec3(0.3, 0.3, 0.3)));
  EXPECT_FALSE(shape->inside(Vec3(0.4, 0.4, 0.4)));
  EXPECT_EQ(shape->bounds(), Box3(Vec3(-1), Vec3(1)));
}

TEST(Mesh, InterpolatesNormalsCoordinatesAndTexturesBetweenCorners) {
  MeshParameters mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces = {{0, 1, 2}};
  mesh.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  mesh.face_normals = {{0, 1, 2}};
  mesh.uv = {Vec2(0, 0), Vec2(2, 0), Vec2(0, 4)};
  mesh.face_uvs = {{0, 1, 2}};
  mesh.face_textures = {{0, 1, 2}};
  const ShapePtr shape = make_mesh(mesh);
  const Ray ray{Vec3(0.25, 0.5, -3), Vec3(0, 0, 1)};
  const std::vector<Crossing> all = met(shape, ray);
  ASSERT_EQ(all.size(), 1u);
  const Vec3 p = ray.at(all[0].depth);
  expect_near(shape->normal(p, all[0]), Vec3(0.25, 0.5, -0.25).normalized(), 1e-6);
  EXPECT_NEAR(shape->uv(p, all[0]).x, 0.5, 1e-9);
  EXPECT_NEAR(shape->uv(p, all[0]).y, 2.0, 1e-9);
  const std::vector<TextureShare> shares = textures_at(*shape, p, all[0]);
  ASSERT_EQ(shares.size(), 3u);
  const double expected[] = {0.25, 0.25, 0.5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(shares[i].texture, i);
    EXPECT_NEAR(shares[i].weight, expected[i], 1e-9);
  }
}

BlobParameters three_balls() {
  BlobParameters blob;
  blob.threshold = 0.65;
  for (const Vec3& center : {Vec3(0.75, 0, 0), Vec3(-0.375, 0.65, 0), Vec3(-0.375, -0.65, 0)}) {
    BlobParameters::Component& part = blob.components.emplace_back();
    part.center = center;
    part.texture = static_cast<std::uint32_t>(blob.components.size() - 1);
  }
  return blob;
}

TEST(Blob, IsAClosedSolid) {
  BlobParameters blob = three_balls();
  check_closed_solid(make_blob(blob), 1);
  BlobParameters::Component& bar = blob.components.emplace_back();
  bar.kind = BlobParameters::Component::Kind::cylinder;
  bar.center = Vec3(-1, 0, 0.3);
  bar.end = Vec3(1, 0.5, 0);
  bar.strength = -0.5;
  bar.placement = Transform::scaling(Vec3(1, 1.5, 1));
  check_closed_solid(make_blob(blob), 2);
  for (int i = 0; i < 30; ++i) {
    BlobParameters::Component& part = blob.components.emplace_back();
    part.center = Vec3(std::cos(i), std::sin(i), std::sin(3 * i));
    part.radius = 0.4;
  }
  check_closed_solid(make_blob(blob), 3);
  check_nearest(make_blob(blob), 4);
}

TEST(Blob, TexturesHaveTheSharesOfTheirFields) {
  const ShapePtr blob = make_blob(three_balls());
  const std::vector<TextureShare> shares = textures_at(*blob, Vec3(-0.375, 0.1, 0.2));
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_GT(shares[0].weight, shares[1].weight);
  EXPECT_NEAR(shares[0].weight + shares[1].weight, 1.0, 1e-12);
}

TEST(Quadric, IsTheSphereThatItDescribes) {
  const ShapePtr ball = make_quadric({Vec3(1.0), Vec3(0.0), Vec3(-2.0, 0.0, 0.0), -1.0});  // (x - 1)^2 + y^2 + z^2 = 2
  const ShapePtr sphere = make_sphere(Vec3(1, 0, 0), std::sqrt(2.0));
  RayRain rain(1);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    const std::vector<double> found = depths(ball, ray);
    const std::vector<double> expected = depths(sphere, ray);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], expected[k], 1e-6);
  }
  check_closed_solid(ball, 2);
  check_closed_solid(ball->placed(uneven_placement()), 3);
  check_placement(ball, uneven_placement(), 4);
  expect_near(ball->bounds().max, Vec3(1 + std::sqrt(2.0), std::sqrt(2.0), std::sqrt(2.0)));
}

TEST(Poly, IsTheTorusThatItDescribes) {
  const double k = 4.0 - 0.25;  // (x^2 + y^2 + z^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), R = 2, r = 0.5
  PolyParameters poly;
  poly.order = 4;
  poly.coefficients.assign(PolyParameters::coefficient_count(4), 0.0);
  const auto set = [&](int x, int y, int z, double value) {
    poly.coefficients[PolyParameters::place(4, x, y, z)] = value;
  };
  set(4, 0, 0, 1);
  set(0, 4, 0, 1);
  set(0, 0, 4, 1);
  set(2, 2, 0, 2);
  set(2, 0, 2, 2);
  set(0, 2, 2, 2);
  set(2, 0, 0, 2 * k - 16);
  set(0, 2, 0, 2 * k);
  set(0, 0, 2, 2 * k - 16);
  set(0, 0, 0, k * k);
  const ShapePtr shape = make_poly(poly);
  const ShapePtr torus = make_torus(2.0, 0.5);
  RayRain rain(1);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    const std::vector<double> found = depths(shape, ray);
    const std::vector<double> expected = depths(torus, ray);
    if (found.size() != expected.size()) continue;  // it grazes
    for (std::size_t n = 0; n < found.size(); ++n) ASSERT_NEAR(found[n], expected[n], 1e-5);
    for (const Crossing& crossing : met(shape, ray)) {
      const Vec3 p = ray.at(crossing.depth);
      ASSERT_NEAR(shape->normal(p, crossing).dot(torus->normal(p, crossing)), 1.0, 1e-6);
    }
  }
  EXPECT_TRUE(shape->inside(Vec3(2.4, 0, 0)));
  EXPECT_FALSE(shape->inside(Vec3(0, 0, 0)));
}

TEST(Superellipsoid, IsAClosedSolid) {
  check_surface(make_superellipsoid(1.0, 1.0), 1);
  check_surface(make_superellipsoid(0.3, 0.6), 2, 1e-6);
  check_nearest(make_superellipsoid(0.5, 0.5), 3);
  const ShapePtr ball = make_superellipsoid(1.0, 1.0);
  expect_depths(ball, {Vec3(-10, 0.1, 0.2), Vec3(1, 0, 0)}, {10 - std::sqrt(0.95), 10 + std::sqrt(0.95)}, 1e-6);
}

TEST(Lathe, OfEachSplineIsAClosedSolid) {
  check_surface(make_lathe({ProfileSpline::linear, {{0, -1}, {1, -0.5}, {0.5, 0.5}, {0, 1}}}), 1);
  check_surface(make_lathe({ProfileSpline::quadratic, {{-0.5, -1.2}, {0, -1}, {1, -0.3}, {0.7, 0.4}, {0, 1}}}), 2);
  check_surface(make_lathe({ProfileSpline::cubic, {{-1, -1}, {0, -1}, {1, -0.3}, {0.7, 0.4}, {0, 1}, {-1, 1}}}), 3);
  check_surface(make_lathe({ProfileSpline::bezier, {{0, -1}, {1.5, -1}, {1, 1}, {0, 1}}}), 4);
}

TEST(Lathe, IsMetByLevelRays) {
  const ShapePtr lathe = make_lathe({ProfileSpline::quadratic, {{-0.5, -1.2}, {0, -1}, {1, -0.3}, {0.7, 0.4}, {0, 1}}});
  for (const double y : {-0.9, -0.3, 0.0, 0.1, 0.7}) {
    const std::vector<double> level = depths(lathe, {Vec3(5, y, 0.1), Vec3(-1, 0, 0)});
    const std::vector<double> steeper = depths(lathe, {Vec3(5, y - 5e-6, 0.1), unit(Vec3(-1, 1e-6, 0))});
    ASSERT_EQ(level.size(), 2u) << y;
    ASSERT_EQ(steeper.size(), 2u) << y;
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(level[i], steeper[i], 1e-4) << y;
  }
}

TEST(Lathe, OfALineIsACone) {
  const ShapePtr lathe = make_lathe({ProfileSpline::linear, {{1, -1}, {0.5, 1}}});
  const ShapePtr cone = make_cone(Vec3(0, -1, 0), 1.0, Vec3(0, 1, 0), 0.5, true);
  RayRain rain(5);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    const std::vector<double> found = depths(lathe, ray);
    const std::vector<double> expected = depths(cone, ray);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], expected[k], 1e-6);
  }
}

TEST(Sor, IsAClosedSolid) {
  const SorParameters vase{{{0, -1.3}, {0.5, -1}, {0.9, -0.4}, {0.4, 0.3}, {0.6, 1}, {0.8, 1.2}}};
  check_surface(make_sor(vase), 1);
  check_placement(make_sor(vase), uneven_placement(), 2);
}

TEST(Prism, OfEachSplineIsAClosedSolid) {
  using Sweep = PrismParameters::Sweep;
  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  check_surface(make_prism({ProfileSpline::linear, Sweep::linear, -0.5, 0.5, square}), 1);
  check_surface(make_prism({ProfileSpline::linear, Sweep::conic, 0.2, 1.2, square}), 2);
  const std::vector<Vec2> curve{{-1, 1}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  check_surface(make_prism({ProfileSpline::cubic, Sweep::linear, -0.5, 0.5, curve}), 3);
  const std::vector<Vec2> arcs{{-1, 0}, {-1, 1.3}, {1, 1.3}, {1, 0}, {1, 0}, {1, -1.3}, {-1, -1.3}, {-1, 0}};
  check_surface(make_prism({ProfileSpline::bezier, Sweep::linear, -0.5, 0.5, arcs}), 4);
}

TEST(Prism, OfALineIsABox) {
  const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  const ShapePtr prism = make_prism({ProfileSpline::linear, PrismParameters::Sweep::linear, -0.5, 0.5, square});
  const ShapePtr box = make_box(Vec3(-1, -0.5, -1), Vec3(1, 0.5, 1));
  RayRain rain(6);
  for (int i = 0; i < 1000; ++i) {
    const Ray ray = rain.next();
    const std::vector<double> found = depths(prism, ray);
    const std::vector<double> expected = depths(box, ray);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], expected[k], 1e-6);
    const Vec3 p = rain.point(1.5);
    ASSERT_EQ(prism->inside(p), box->inside(p)) << p;
  }
}

TEST(Ovus, IsAClosedSolid) {
  check_closed_solid(make_ovus(1.0, 0.6), 1);
  check_closed_solid(make_ovus(0.8, 1.1), 2);
  check_placement(make_ovus(1.0, 0.5), uneven_placement(), 3);
  expect_depths(make_ovus(1.0, 0.5), {Vec3(0, -5, 0), Vec3(0, 1, 0)}, {4.0, 6.5});
}

TEST(Polygon, HasHoles) {
  const ShapePtr frame = make_polygon({Vec3(0, 0, 1), Vec3(3, 0, 1), Vec3(3, 3, 1), Vec3(0, 3, 1), Vec3(0, 0, 1),
                                       Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(2, 2, 1), Vec3(1, 2, 1), Vec3(1, 1, 1)});
  ASSERT_TRUE(frame);
  expect_depths(frame, {Vec3(0.5, 0.5, -1), Vec3(0, 0, 1)}, {2.0});
  expect_depths(frame, {Vec3(1.5, 1.5, -1), Vec3(0, 0, 1)}, {});
  expect_depths(frame, {Vec3(3.5, 1.5, -1), Vec3(0, 0, 1)}, {});
  EXPECT_FALSE(make_polygon({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}));
}

TEST(BicubicPatch, OfAFlatNetIsASquare) {
  BicubicPatchParameters patch;
  patch.u_steps = patch.v_steps = 3;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      patch.points[i][k] = Vec3(static_cast<double>(i) / 3.0, static_cast<double>(k) / 3.0, 0.5);
    }
  }
  const ShapePtr shape = make_bicubic_patch(patch);
  const Ray ray{Vec3(0.3, 0.6, -2), Vec3(0, 0, 1)};
  expect_depths(shape, ray, {2.5});
  const std::vector<Crossing> all = met(shape, ray);
  expect_near(shape->normal(ray.at(2.5), all[0]), Vec3(0, 0, 1));
  EXPECT_NEAR(shape->uv(ray.at(2.5), all[0]).x, 0.6, 1e-9);
  EXPECT_NEAR(shape->uv(ray.at(2.5), all[0]).y, 0.3, 1e-9);
  expect_depths(shape, {Vec3(1.1, 0.6, -2), Vec3(0, 0, 1)}, {});
  patch.u_steps = patch.v_steps = 9;  // too many pieces to keep
  const ShapePtr fine = make_bicubic_patch(patch);
  expect_depths(fine, ray, {2.5});
}

TEST(HeightField, IsMetWhereItIsHigh) {
  HeightFieldParameters field;
  field.columns = 40;
  field.rows = 30;
  for (int z = 0; z < 30; ++z) {
    for (int x = 0; x < 40; ++x) {
      field.heights.push_back(static_cast<std::uint16_t>(30000 + 20000 * std::sin(x * 0.4) * std::cos(z * 0.3)));
    }
  }
  const ShapePtr shape = make_height_field(field);
  RayRain rain(7, 3.0, 1.0);
  int count = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = rain.next();
    for (const Crossing& crossing : met(shape, ray)) {
      const Vec3 p = ray.at(crossing.depth);
      ++count;
      ASSERT_TRUE(padded(shape->bounds(), 1e-6, 1e-9).intersects(p));
      ASSERT_NEAR(shape->normal(p, crossing).length(), 1.0, 1e-12);
      if (p.x < 0.01 || p.x > 0.99 || p.z < 0.01 || p.z > 0.99) continue;
      ASSERT_TRUE(shape->inside(p - Vec3(0, 1e-5, 0)));
      ASSERT_FALSE(shape->inside(p + Vec3(0, 1e-5, 0)));
    }
  }
  EXPECT_GT(count, 200);
  check_nearest(shape, 8);
  // From above each place is met at one height.
  for (double x = 0.013; x < 1.0; x += 0.07) {
    for (double z = 0.017; z < 1.0; z += 0.07) {
      const std::vector<double> found = depths(shape, {Vec3(x, 3, z), Vec3(0, -1, 0)});
      ASSERT_FALSE(found.empty()) << x << " " << z;
      EXPECT_NEAR(found.front(), found.back(), 1e-9) << "two triangles, at their common side";
    }
  }
}

}  // namespace
}  // namespace firstlight::render
