#pragma once

#include "parser/directive/reader.h"
#include "render/math/vec.h"

#include <cstddef>
#include <optional>

namespace firstlight::parser {

/// Triangles, corners or normals of one mesh; more would not fit into a machine's memory.
constexpr std::size_t kMostFaces = std::size_t{1} << 25;

/// A normal of a mesh, of any length; one without length is replaced, with a warning the first time.
render::Vec3 parse_mesh_normal(Reader& reader, bool& warned);
/// Parses the vector behind `inside_vector`; of unit length, nothing when it is zero.
std::optional<render::Vec3> parse_inside_vector(Reader& reader);

}  // namespace firstlight::parser
