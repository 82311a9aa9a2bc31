#pragma once

#include "render/math/transform.h"
#include "render/shape/shape.h"

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Where the sum of the components' fields reaches the threshold. A component's field falls from `strength` in its
/// middle to 0 at its radius: strength * (1 - (d / radius)^2)^2. [POV-Ray 3.7 manual, "Blob"]
struct BlobParameters {
  struct Component {
    enum class Kind : std::uint8_t { sphere, cylinder };

    Kind kind = Kind::sphere;
    Vec3 center{0.0, 0.0, 0.0};  ///< of a cylinder: one end, around which the field is half a ball
    Vec3 end{0.0, 0.0, 0.0};     ///< of a cylinder: the other
    double radius = 1.0;
    double strength = 1.0;
    Transform placement;                     ///< to the blob's space
    std::uint32_t texture = kObjectTexture;  ///< in the shape's own list
  };

  double threshold = 1.0;
  std::vector<Component> components;  ///< at least one
};

/// Pre: no cylinder is without length.
ShapePtr make_blob(const BlobParameters& parameters);

}  // namespace firstlight::render
