#pragma once

#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Kinds of a ray, by what it is looking for.
enum class RayKind : std::uint8_t { primary, reflection, transmission, shadow };

/// How many kinds there are: the size of what is kept by kind.
constexpr std::size_t kRayKinds = 4;
/// A kind takes so many bits of a RayTask.
constexpr int kRayKindBits = 3;
static_assert(kRayKinds <= std::size_t{1} << kRayKindBits);

}  // namespace firstlight::render
