#pragma once

namespace firstlight::render {

struct Scene;

/// Takes out of a scene what its quality does not show, as far as that is a matter of what is in the scene and not of
/// how rays see it: lights that do not count, the areas of lights, what fills the space.
void simplify(Scene& scene);

}  // namespace firstlight::render
