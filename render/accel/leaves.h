#pragma once

#include "render/accel/accel.h"
#include "render/accel/wide_tree.h"
#include "render/shape/box.h"
#include "render/shape/plane.h"
#include "render/shape/sphere.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// What every leaf knows of the solid that it stands for.
struct LeafHead {
  const Shape* shape = nullptr;  ///< null for a solid that is more than one shape
  std::uint32_t part = kNoIndex;
  std::uint32_t solid = kNoIndex;
  std::uint8_t hidden_from = 0;
  bool opaque = false;  ///< for a solid of several parts: any of them
};

struct SphereLeaf {
  Vec3 center;
  double radius_squared;
  LeafHead head;
};
struct BoxLeaf {
  AxisBox box;
  LeafHead head;
};
struct PlaneLeaf {
  const Plane* plane;
  LeafHead head;
};
struct SolidLeaf {
  const Solid* geometry;
  LeafHead head;
};

/// The scene's solids as the traversal meets them. Round spheres, axis-aligned boxes and planes without clips and
/// bounds are unpacked, so they cost no virtual call and no list; everything else is asked through its solid.
struct Leaves {
  std::vector<SphereLeaf> spheres;
  std::vector<BoxLeaf> boxes;
  std::vector<SolidLeaf> solids;
  std::vector<PlaneLeaf> planes;   ///< tested for every ray, as are the next
  std::vector<ChildRef> beside;    ///< leaves whose box does not fit a tree
  std::vector<bool> opaque_parts;  ///< Part::opaque of each part
  WideTree tree;

  explicit Leaves(const Scene& scene);
};

// The bodies of the hierarchy's traversal, for the best instruction set that the machine has.
void find_closest(const Leaves& leaves, std::span<const RayQuery> queries, std::span<Hit> hits);
void find_occluded(const Leaves& leaves, std::span<const RayQuery> queries, std::span<std::uint8_t> blocked);

}  // namespace firstlight::render
