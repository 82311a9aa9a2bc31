#include "render/math/ray_tree.h"

#include "render/math/polynomial.h"
#include "tests/render/shape_test_support.h"

#include <set>

namespace firstlight::render {
namespace {

TEST(RayTree, VisitsEveryBoxThatARayMeets) {
  RayRain rain(1, 10.0, 10.0);
  std::vector<Box3> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec3 corner = rain.point(5.0);
    boxes.emplace_back(corner, corner + Vec3(0.3, i % 7 == 0 ? 0.0 : 0.4, 0.2));
  }
  for (int i = 0; i < 20; ++i) boxes.push_back(boxes[0]);
  const RayTree tree(boxes);
  for (int i = 0; i < 500; ++i) {
    Ray ray = rain.next();
    if (i % 5 == 0) ray.direction = Vec3(0, i % 2 == 0 ? 1 : -1, 0);
    std::multiset<std::uint32_t> found;
    tree.walk(ray, kBoundless, [&](std::uint32_t box) { found.insert(box); });
    for (std::uint32_t box = 0; box < boxes.size(); ++box) {
      ASSERT_LE(found.count(box), 1u);
      ASSERT_TRUE(found.count(box) == 1 || !meets(ray, boxes[box]));
    }
    ASSERT_LT(found.size(), 200u);
  }
}

TEST(RayTree, OfNothingVisitsNothing) {
  RayTree().walk({Vec3(0.0), Vec3(1, 0, 0)}, kBoundless, [](std::uint32_t) { FAIL(); });
}

TEST(Polynomial, OfAnyOrderHasItsRoots) {
  const std::vector<double> expected{-2.5, -1.0, 0.25, 0.5, 1.5, 2.0, 3.0};
  std::vector<double> c{1.0};
  for (const double root : expected) {
    std::vector<double> product(c.size() + 1, 0.0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      product[i] -= root * c[i];
      product[i + 1] += c[i];
    }
    c = product;
  }
  std::array<double, 7> roots;
  ASSERT_EQ(polynomial_roots(c, -10.0, 10.0, roots), 7u);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(roots[i], expected[i], 1e-10);
  ASSERT_EQ(polynomial_roots(c, 0.0, 1.0, roots), 2u);
  EXPECT_NEAR(roots[0], 0.25, 1e-12);
  EXPECT_EQ(polynomial_roots(std::vector<double>{1.0}, 0.0, 1.0, roots), 0u);
  ASSERT_EQ(polynomial_roots(std::vector<double>{-1.0, 2.0}, 0.0, 1.0, roots), 1u);
  EXPECT_NEAR(roots[0], 0.5, 1e-12);
}

}  // namespace
}  // namespace firstlight::render
