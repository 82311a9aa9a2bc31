#pragma once

#include "render/accel/accel.h"
#include "render/accel/leaf/box.h"
#include "render/accel/leaf/plane.h"
#include "render/accel/leaf/solid.h"
#include "render/accel/leaf/sphere.h"
#include "render/accel/tie_order.h"
#include "render/accel/wide_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The scene's solids as the traversal meets them. Round spheres, axis-aligned boxes and planes without clips and
/// bounds are unpacked, so they cost no virtual call and no list; everything else is asked through its solid.
struct Leaves {
  std::vector<SphereBlock> sphere_blocks;
  std::vector<LeafHead> spheres;  ///< lane l of block b is sphere 8 b + l
  std::vector<BoxLeaf> boxes;
  std::vector<SolidLeaf> solids;
  std::vector<PlaneLeaf> planes;   ///< met by every ray, in the order of their solids
  std::vector<ChildRef> beside;    ///< leaves whose box does not fit a tree
  std::vector<bool> opaque_parts;  ///< Part::opaque of each part
  WideTree tree;
  TieOrder tie_order;

  explicit Leaves(const Scene& scene);

  // Pre of both: `ref` is a leaf of one solid, neither a node nor spheres.
  const LeafHead& head(ChildRef ref) const {
    return ref.kind() == ChildKind::box ? boxes[ref.index()].head : solids[ref.index()].head;
  }
  const FloatBox& bounds(ChildRef ref) const {
    return ref.kind() == ChildKind::box ? boxes[ref.index()].bounds : solids[ref.index()].bounds;
  }

 private:
  void add_block(std::span<const RoundSphere> all, const SphereGroup& group);
};

// The bodies of the hierarchy's traversal, for the best instruction set that the machine has.
void find_closest(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits);
std::uint64_t find_occluded(const Leaves& leaves, const RayBlock& rays);

}  // namespace firstlight::render
