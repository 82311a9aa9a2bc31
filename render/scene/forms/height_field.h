#pragma once

#include "render/texture/image_use.h"

namespace firstlight::render {

/// A landscape over the unit square, as high as a picture is bright; 0 to 1. [POV-Ray 3.7 manual, "Height Field"]
struct HeightFieldForm {
  ImageSource image;
  double water_level = 0.0;  ///< what is below is left out
  bool smooth = false;       ///< normals are interpolated
};

}  // namespace firstlight::render
