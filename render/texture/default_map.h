#pragma once

#include "render/texture/pigment.h"

namespace firstlight::render {

/// The colours of a pattern whose pigment gives none. [POV-Ray 3.7]
const ColorMap& default_map(const Patterning& pattern);

}  // namespace firstlight::render
