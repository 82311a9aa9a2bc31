#pragma once

#include "render/accel/accel.h"
#include "render/accel/tie_order.h"
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

/// How many spheres are tested at once.
constexpr std::size_t kLanes = 8;

/// Eight spheres side by side. An unused lane has a radius squared of minus infinity, so no ray meets it.
struct alignas(64) SphereBlock {
  double center[3][kLanes];
  double radius_squared[kLanes];
  float bounds[6][kLanes];           ///< as in WideNode, without its room
  std::uint8_t hidden_from[kLanes];  ///< LeafHead::hidden_from
  std::uint8_t hidden_from_any;      ///< the bits of all
  std::uint8_t opaque;               ///< bit l: LeafHead::opaque of lane l
};
struct PlaneLeaf {
  Vec3 normal;
  double offset;
  LeafHead head;
  bool in_doubt = false;  ///< another lies where it lies
};

struct BoxLeaf {
  AxisBox box;
  FloatBox bounds;
  LeafHead head;
};
struct SolidLeaf {
  const Solid* geometry;
  FloatBox bounds;
  LeafHead head;
  bool is_cramped;   ///< Solid::is_cramped()
  bool only_blocks;  ///< it is met by feelers alone, and only where they ask for what is opaque
};

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

 private:
  struct RoundSphere {
    const Sphere* sphere;
    FloatBox bounds;
    LeafHead head;
  };

  void add_block(const std::vector<RoundSphere>& all, const SphereGroup& group);
};

/// Marks planes that lie in one place.
void mark_coincident(std::span<PlaneLeaf> planes);

// The bodies of the hierarchy's traversal, for the best instruction set that the machine has.
void find_closest(const Leaves& leaves, const RayBlock& rays, std::span<Hit> hits);
std::uint64_t find_occluded(const Leaves& leaves, const RayBlock& rays);

}  // namespace firstlight::render
