#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace firstlight::render {

/// Kinds of a surface by what it does with rays, as far as it matters to which of them come first.
enum class SurfaceKind : std::uint8_t {
  plain,   ///< none of the others
  glossy,  ///< highlights
  mirror,  ///< reflects, and lets nothing through
  clear,   ///< lets light through
};

/// Surfaces that a user can tell apart: by the identifiers they were declared under, and by what they are.
struct ObjectGroup {
  std::vector<std::string> names;  ///< SDL identifiers, the outermost object's first; empty for what has none
  std::string shape;               ///< SDL word of the primitive; may be empty
  SurfaceKind surface = SurfaceKind::plain;
  /// The number of objects, itself among them, that the top-level solid is made of, as the bits of that number.
  std::uint8_t complexity = 1;
};

/// Groups in a scene; what comes when all numbers are taken goes to the last one, which has no names.
constexpr std::uint32_t kMostObjectGroups = 0xffff;

}  // namespace firstlight::render
