#include "render/scene/cutaway.h"

#include "render/scene/scene.h"

#include <algorithm>
#include <cstddef>

namespace firstlight::render {

void add_cut_textures(const Scene& scene, std::uint32_t cutaway, const Vec3& point, std::uint32_t place,
                      std::vector<TextureShare>& out) {
  const Cutaway& cut = scene.cutaways[cutaway];
  const std::size_t first = out.size();
  for (const Cutaway::Member& member : cut.members) {
    if (member.solid.inside(point)) {
      if (member.within != Cutaway::kNone) {
        add_cut_textures(scene, member.within, point, place, out);
      } else if (member.texture != Cutaway::kNone) {
        out.push_back({place, member.texture, 1.0});
      }
    }
    if (cut.first_alone) return;
  }
  const auto share = 1.0f / static_cast<float>(std::max<std::size_t>(out.size() - first, 1));
  for (std::size_t i = first; i < out.size(); ++i) out[i].weight = static_cast<double>(share);
}

}  // namespace firstlight::render
