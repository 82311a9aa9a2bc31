#include "app/antialias.h"

namespace firstlight::app {

std::optional<render::AntialiasSettings> antialias_of(const Options& options, const render::Settings& scene) {
  std::optional<render::AntialiasSettings> out = options.antialias;
  if (!out) return out;
  switch (scene.gamma) {
    case render::WorkingGamma::power:
      out->working_exponent = scene.gamma_exponent;
      break;
    case render::WorkingGamma::srgb:
      out->working_srgb = true;
      break;
    case render::WorkingGamma::linear:
    case render::WorkingGamma::unmanaged:
      break;
  }
  return out;
}

}  // namespace firstlight::app
