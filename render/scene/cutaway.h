#pragma once

#include "render/scene/solid.h"
#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

struct Scene;

/// A combination in which `cutaway_textures` stands somewhere: parts of it that have no texture show those of what they
/// cut.
struct Cutaway {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  struct Member {
    Solid solid;                    ///< asked whether it holds a point
    std::uint32_t texture = kNone;  ///< of a shape: into Scene::textures
    std::uint32_t within = kNone;   ///< of a combination: its own, into Scene::cutaways
  };
  bool first_alone = false;  ///< of a difference: what is taken away counts for nothing
  std::vector<Member> members;
};

/// Appends the textures that are seen at `point`, which is `place`, of a part without one: those of the members that
/// hold it, with equal shares. They are numbers into Scene::textures.
/// Source  POV-Ray 3.7: of combinations within a difference the shares are their own, of those within others they are
///         not.
void add_cut_textures(const Scene& scene, std::uint32_t cutaway, const Vec3& point, std::uint32_t place,
                      std::vector<TextureShare>& out);

}  // namespace firstlight::render
