#pragma once

#include "render/accel/float_box.h"
#include "render/accel/leaf/head.h"
#include "render/shape/box.h"

namespace firstlight::render {

/// A box along the axes.
struct BoxLeaf {
  AxisBox box;
  FloatBox bounds;
  LeafHead head;
};

}  // namespace firstlight::render
