#pragma once

namespace firstlight::render {

/// Pixels between the points of the coarsest grid of primary rays, with which a picture begins; a power of two.
constexpr int kCoarsestGrid = 16;

}  // namespace firstlight::render
