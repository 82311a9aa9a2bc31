#pragma once

#include "render/math/box_tree.h"
#include "render/scene/solid.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace firstlight::render {

/// A bounding object counts as met from this depth on. [POV-Ray 3.7]
constexpr double kNearestBound = 1e-4;

/// Bits of Solid::hidden_from that hide a member of a solid of this kind from a ray.
/// Source   POV-Ray 3.7: a union asks for no_reflection, and for no_image of what has come through a surface only (of a
///          member it does not hide it from the camera itself), a merge asks for both, an intersection for none, and
///          no_shadow counts for whole objects alone.
inline std::uint8_t hiding_in(Solid::Kind kind, std::uint8_t hidden_bit) {
  switch (kind) {
    case Solid::Kind::union_:
      return (hidden_bit & kSentThrough) != 0 ? kHiddenFromPrimary : kHiddenFromReflection & hidden_bit;
    case Solid::Kind::merge:
      return (kHiddenFromPrimary | kHiddenFromReflection) & hidden_bit;
    default:
      return 0;
  }
}

/// Parts of a solid that is not plain.
struct Solid::Structure {
  /// Trees over many members: over those whose surface a ray may meet, and those that may decide whether a point is
  /// inside.
  struct MemberTrees {
    BoxTree surface;
    BoxTree deciding;
  };

  std::vector<Solid> members;
  std::vector<Solid> clips;
  std::vector<Solid> bounds;
  std::optional<Extent> extent;
  std::optional<Box3> given_box;  // of the extent, where the solid is cramped
  Box3 box;                       // of the whole; filled by close(), as all below
  Reach reach;
  std::vector<Box3> member_boxes;     // asked before the members
  std::vector<Reach> member_reaches;  // likewise
  std::vector<Box3> bound_boxes;
  std::shared_ptr<const MemberTrees> trees;  // null for few members
  std::uint32_t levels = 0;                  // how deep solids lie in each other, this one included
  bool hides_some = false;                   // whether any within is hidden from some kind of ray

  void close_members(Kind kind);
  void plant_trees(Kind kind);
};

}  // namespace firstlight::render
