#include "render/scene/file_encoding.h"

namespace firstlight::render {

Encoding file_encoding(const Settings& settings) {
  switch (settings.gamma) {
    case WorkingGamma::linear:
      return Encoding::linear();
    case WorkingGamma::power:
      return Encoding::power(settings.gamma_exponent);
    case WorkingGamma::srgb:
      return Encoding::srgb();
    case WorkingGamma::unmanaged:
      break;
  }
  return Encoding::as_is();
}

}  // namespace firstlight::render
