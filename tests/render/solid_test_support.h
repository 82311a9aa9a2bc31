#pragma once

#include "render/scene/scene.h"
#include "render/scene/solid.h"
#include "render/shape/primitives.h"

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace firstlight::render {

inline Solid solid_of(ShapePtr shape, std::uint32_t part = 0) {
  Solid solid;
  solid.shape = std::move(shape);
  solid.part = part;
  solid.close();
  return solid;
}

inline Solid combined(Solid::Kind kind, std::vector<Solid> members) {
  Solid solid;
  solid.kind = kind;
  solid.set_members(std::move(members));
  solid.close();
  return solid;
}

inline Solid clipped(Solid solid, Solid clip) {
  std::vector<Solid> clips = solid.clips();
  clips.push_back(std::move(clip));
  solid.set_clips(std::move(clips));
  solid.close();
  return solid;
}

inline Solid bounded(Solid solid, Solid bound) {
  std::vector<Solid> bounds = solid.bounds();
  bounds.push_back(std::move(bound));
  solid.set_bounds(std::move(bounds));
  solid.close();
  return solid;
}

/// Adds a solid with its parts numbered on from the scene's; all of them opaque or none.
inline void add_solid(Scene& scene, Solid solid, bool opaque = true) {
  struct Numbering {
    Scene& scene;
    bool opaque;
    void number(Solid& s) {
      if (s.kind == Solid::Kind::shape) {
        s.part = static_cast<std::uint32_t>(scene.parts.size());
        Part part;
        part.opaque = opaque;
        scene.parts.push_back(part);
      }
      std::vector<Solid> members = s.members();
      for (Solid& member : members) number(member);
      s.set_members(std::move(members));
    }
  };
  Numbering{scene, opaque}.number(solid);
  scene.solids.push_back(std::move(solid));
}

}  // namespace firstlight::render
