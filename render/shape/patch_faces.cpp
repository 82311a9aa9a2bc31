#include "render/shape/patch_faces.h"

#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/patch_faces.cpp"
#include <hwy/foreach_target.h>

#include "render/math/ray_tree-inl.h"
#include "render/shape/lane_shape-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

constexpr double kNearestOfPatch = 1e-5;

template <class L>
struct PatchTriangleOf {
  Vec3Of<L> common, normal, to_a, to_b;
  L determinant;
};

template <class L>
struct PatchTriangleMet {
  MaskOf<L> met;
  L depth, a, b;
};

template <class L>
HWY_INLINE PatchTriangleMet<L> meet(const PatchTriangleOf<L>& triangle, const RayOf<L>& ray) {
  const L approach = dot(ray.direction, triangle.normal);
  const L depth = dot(triangle.common - ray.origin, triangle.normal) / approach;
  const Vec3Of<L> q = ray.origin + ray.direction * depth - triangle.common;
  const L a = dot(q, triangle.to_a) / triangle.determinant;
  const L b = dot(q, triangle.to_b) / triangle.determinant;
  const auto met = (abs(approach) >= kEpsilon) & (depth >= kNearestOfPatch) & (a >= 0.0) & (b >= 0.0) & (a + b <= 1.0);
  return {met, depth, a, b};
}

HWY_INLINE Vec3Of<Lanes> vector_from(const double (&of)[3][PatchFaces::Block::kSize], std::size_t i) {
  return {Lanes::load(of[0] + i), Lanes::load(of[1] + i), Lanes::load(of[2] + i)};
}

/// Ray `number` meets the pieces of a block.
HWY_INLINE void meet_block(const PatchFaces::Block& block, const Ray& given, std::uint32_t number,
                           std::vector<PatchFaces::Met>& out) {
  const RayOf<Lanes> ray{everywhere<Lanes>(given.origin), everywhere<Lanes>(given.direction)};
  for (std::size_t i = 0; i < PatchFaces::Block::kSize; i += Lanes::kCount) {
    const Vec3Of<Lanes> common = vector_from(block.common, i);
    unsigned met[2];
    double numbers[2][3][Lanes::kCount];
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [row, determinant] = block.triangles[k];
      const auto there = meet(PatchTriangleOf<Lanes>{common, vector_from(row[0], i), vector_from(row[1], i),
                                                     vector_from(row[2], i), Lanes::load(determinant + i)},
                              ray);
      met[k] = bits(there.met);
      if (met[k] == 0) continue;
      there.depth.store(numbers[k][0]);
      there.a.store(numbers[k][1]);
      there.b.store(numbers[k][2]);
    }
    for (unsigned left = met[0] | met[1]; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(left));
      for (std::size_t k = 0; k < 2; ++k) {
        if ((met[k] >> lane & 1) == 0) continue;
        const auto face = static_cast<std::uint32_t>(2 * block.piece[i + lane] + k);
        out.push_back({number, face, numbers[k][0][lane], numbers[k][1][lane], numbers[k][2][lane]});
      }
    }
  }
}

void meet_patch(const PatchFaces& faces, const RayColumns& rays, std::uint64_t who, const Column<double>& high,
                std::vector<PatchFaces::Met>& out) {
  TreeWalk(faces.tree(), rays)
      .walk(
          who, high,
          [&](std::uint32_t leaf, std::uint64_t coming) HWY_ATTR {
            for (; coming != 0; coming &= coming - 1) {
              const auto i = static_cast<std::size_t>(__builtin_ctzll(coming));
              meet_block(faces.block(leaf), rays.ray(i), static_cast<std::uint32_t>(i), out);
            }
          },
          [&](std::uint32_t leaf) HWY_ATTR { fetch_ahead(faces.block(leaf)); });
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(meet_patch);

PatchFaces::Triangle::Triangle(const Vec3& common, const Vec3& p1, const Vec3& p2) {
  const Vec3 b0 = p1 - common;
  const Vec3 b1 = p2 - common;
  Vec3 b2 = b0.cross(b1);
  const double square = b2.length2();
  if (square <= kEpsilon * b1.length2() * b0.length2()) return;
  b2 = b2 * (1.0 / std::sqrt(square));
  const double found = b0.dot(b1.cross(b2));
  if (std::abs(found) < kEpsilon) return;
  determinant = found;
  row = {b0.cross(b1) / determinant, b1.cross(b2), b2.cross(b0)};
}

PatchFaces::PatchFaces(const std::vector<Corners>& pieces) {
  std::vector<RayTree::Item> items;
  items.reserve(pieces.size());
  for (const Corners& corners : pieces) {
    Box3 box;
    for (const Vec3& corner : corners) box.extendBy(corner);
    items.push_back({{Imath::V3f(box.min), Imath::V3f(box.max)}, static_cast<std::uint32_t>(items.size())});
  }
  tree_ = RayTree(std::move(items));
  blocks_.reserve(tree_.leaves().size());
  for (const RayTree::Leaf& leaf : tree_.leaves()) blocks_.push_back(block_of(leaf, pieces));
}

PatchFaces::Block PatchFaces::block_of(const RayTree::Leaf& leaf, const std::vector<Corners>& pieces) {
  Block block{};
  block.piece = leaf;
  for (std::size_t i = 0; i < Block::kSize; ++i) {
    for (Block::Triangles& triangles : block.triangles) triangles.determinant[i] = 1.0;
    if (leaf[i] == RayTree::kNone) continue;
    const Corners& corners = pieces[leaf[i]];
    const Triangle both[] = {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<unsigned>(axis);
      block.common[axis][i] = corners[0][along];
      for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t r = 0; r < 3; ++r) block.triangles[k].row[r][axis][i] = both[k].row[r][along];
      }
    }
    for (std::size_t k = 0; k < 2; ++k) block.triangles[k].determinant[i] = both[k].determinant;
  }
  return block;
}

void PatchFaces::meet(const RayColumns& rays, std::uint64_t who, const Column<double>& high,
                      std::vector<Met>& out) const {
  HWY_DYNAMIC_DISPATCH(meet_patch)(*this, rays, who, high, out);
}

void PatchFaces::meet(const Corners& piece, const Ray& ray, std::uint32_t number, std::vector<Met>& out) {
  using HWY_NAMESPACE::everywhere;
  for (std::uint32_t k = 0; k < 2; ++k) {
    const Triangle of(piece[0], piece[k + 1], piece[k + 2]);
    const auto there = HWY_NAMESPACE::meet(
        HWY_NAMESPACE::PatchTriangleOf<One>{everywhere<One>(piece[0]), everywhere<One>(of.row[0]),
                                            everywhere<One>(of.row[1]), everywhere<One>(of.row[2]), of.determinant},
        HWY_NAMESPACE::RayOf<One>{everywhere<One>(ray.origin), everywhere<One>(ray.direction)});
    if (there.met.holds) out.push_back({0, 2 * number + k, there.depth.v, there.a.v, there.b.v});
  }
}

}  // namespace firstlight::render
#endif
