#pragma once

#include "render/math/columns.h"

#include <cstddef>

namespace firstlight::render {

/// Gives the first `count` vectors unit length, as unit() does with one: what is 0 stays so.
void make_unit(Columns3<double>& vectors, std::size_t count);

}  // namespace firstlight::render
