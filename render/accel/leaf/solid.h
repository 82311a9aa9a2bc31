#pragma once

#include "render/accel/float_box.h"
#include "render/accel/leaf/head.h"
#include "render/scene/solid.h"

#include <vector>

namespace firstlight::render {

/// Any solid, asked through its own functions.
struct SolidLeaf {
  const Solid* geometry;
  FloatBox bounds;
  LeafHead head;
  bool is_cramped;   ///< Solid::is_cramped()
  bool in_blocks;    ///< Solid::suits_blocks()
  bool only_blocks;  ///< it is met by feelers alone, and only where they ask for what is opaque
};

/// Those parts of a cramped solid that cast shadows also where the feeler misses the box of the whole.
/// Source   POV-Ray 3.7 asks the object that blocked a light last before all others, and then not the box of the
///          whole, but that of the member alone, if its kind of shape asks it. So nearly all feelers meet it without
///          the box. Which do not depends on the order of the pixels there; here all do, but of planes, whose shadows
///          would be everywhere, none.
std::vector<const Solid*> blockers_of(const Solid& cramped);

}  // namespace firstlight::render
