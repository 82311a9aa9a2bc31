#pragma once

#include "render/math/columns.h"

#include <cstddef>

namespace firstlight::render {

class Transform;

/// Transform::inverse_point() of those of the points that are in [first, end); the others of `out` stay.
void inverse_points(const Transform& transform, const Columns3<double>& points, std::size_t first, std::size_t end,
                    Columns3<double>& out);

/// Takes those of the normals that are in [first, end) into the space that the transformation leads to, with unit length,
/// and turns them round if asked to.
void place_normals(const Transform& transform, bool inverted, std::size_t first, std::size_t end,
                   Columns3<double>& normals);

}  // namespace firstlight::render
