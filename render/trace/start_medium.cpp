#include "render/trace/start_medium.h"

#include "render/scene/scene.h"
#include "render/trace/medium_table.h"

namespace firstlight::render {
namespace {

bool may_enter(const Solid& solid, std::uint32_t medium, const MediumTable& media) {
  return solid.matter != Solid::kNoMatter && !media.contains(medium, solid.matter);
}

}  // namespace

std::uint32_t medium_at(const Scene& scene, MediumTable& media, const Vec3& point) {
  std::uint32_t medium = MediumTable::kOutside;
  for (const Solid& solid : scene.solids) {
    if (may_enter(solid, medium, media) && solid.holds_start(point)) medium = media.entered(medium, solid.matter);
  }
  return medium;
}

bool may_hold_start(const Solid& solid, const Box3& origins) {
  if (solid.matter == Solid::kNoMatter) return false;
  return origins.min == origins.max ? solid.holds_start(origins.min) : solid.may_hold_start(origins);
}

StartMedium::StartMedium(const Scene& scene, MediumTable& media, const Box3& origins)
    : media_(media), everywhere_(MediumTable::kOutside) {
  if (origins.min == origins.max) {
    everywhere_ = medium_at(scene, media, origins.min);
    return;
  }
  for (const Solid& solid : scene.solids) {
    if (may_hold_start(solid, origins)) holders_.push_back({&solid, solid.start_extent()});
  }
}

std::uint32_t StartMedium::ask(const Vec3& origin) const {
  std::uint32_t medium = MediumTable::kOutside;
  for (const auto& [solid, extent] : holders_) {
    if (extent && !extent->holds(origin)) continue;
    if (may_enter(*solid, medium, media_) && solid->inside_without_clips(origin)) {
      medium = media_.entered(medium, solid->matter);
    }
  }
  return medium;
}

}  // namespace firstlight::render
