#include "render/math/ray_tree.h"

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
  const RayTree tree(boxes, 3);
  for (int i = 0; i < 500; ++i) {
    Ray ray = rain.next();
    if (i % 5 == 0) ray.direction = Vec3(0, i % 2 == 0 ? 1 : -1, 0);
    std::vector<RayTree::Found> all;
    tree.find(ray, kBoundless, all);
    std::multiset<std::uint32_t> found;
    for (const RayTree::Found& one : all) found.insert(one.box);
    for (std::uint32_t box = 0; box < boxes.size(); ++box) {
      ASSERT_LE(found.count(box), 1u);
      ASSERT_TRUE(found.count(box) == 1 || !meets(ray, boxes[box]));
    }
    ASSERT_LT(found.size(), 200u);
  }
}

TEST(RayTree, OfNothingVisitsNothing) {
  std::vector<RayTree::Found> found;
  RayTree().find({Vec3(0.0), Vec3(1, 0, 0)}, kBoundless, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace firstlight::render
