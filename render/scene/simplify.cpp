#include "render/scene/simplify.h"

#include "render/scene/scene.h"

namespace firstlight::render {
namespace {

void remove_matter(Scene& scene) {
  scene.atmosphere.fogs.clear();
  scene.atmosphere.rainbows.clear();
  scene.atmosphere.media.clear();
  for (Shared<Interior>& interior : scene.interiors) {
    if (!interior->media.empty()) interior.change().media.clear();
  }
  for (const Feature feature : {Feature::media, Feature::photons, Feature::radiosity, Feature::subsurface}) {
    scene.unrendered.remove(feature);
  }
}

}  // namespace

void simplify(Scene& scene) {
  const Quality& quality = scene.settings.quality;
  if (!quality.has_matter()) remove_matter(scene);
  if (!quality.has_light()) scene.lights.clear();
  for (Light& light : scene.lights) {
    if (!quality.has_areas()) light.area.reset();
    light.unblocked = !quality.has_shadows();
  }
}

}  // namespace firstlight::render
