#pragma once

#include "render/texture/pattern.h"

#include <memory>

namespace firstlight::render {

// Makers of the patterns; the arguments are those of the scene language.

/// Rises by one with every unit of way along `axis`, whose own length does not matter. Zero everywhere for a zero axis.
std::shared_ptr<const Pattern> make_gradient(const Vec3& axis);

/// Unit cubes, by turns 0 and 1. A list pattern: use it with Pigment::stepped.
std::shared_ptr<const Pattern> make_checker();

}  // namespace firstlight::render
