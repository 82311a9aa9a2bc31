#pragma once

#include "render/math/vec.h"

namespace firstlight::render {

/// A scalar field over space that a pigment turns into colours; pure and immutable.
/// Source   Values are those of POV-Ray 3.7's pattern of the same name, before frequency, phase and wave form.
class Pattern {
 public:
  virtual ~Pattern() = default;
  virtual double value(const Vec3& point) const = 0;
};

}  // namespace firstlight::render
