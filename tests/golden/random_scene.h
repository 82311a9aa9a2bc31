#pragma once
#include <cstdint>
#include <string>

namespace firstlight::golden {

/// The text of a scene of random objects, combined up to four deep: all shapes, unions, merges, intersections and
/// differences, clipped, inverted, moved, matt, clear and reflecting, with a camera that may be inside of them. Equal
/// seeds give equal scenes, on every machine.
std::string random_csg_scene(std::uint64_t seed);

/// The text of a scene with things that lie in one place, as far as they do: pairs of all shapes that share a face, or
/// a whole surface. `number` chooses the pair, which of the two comes first, whether an infinite plane is there, and how
/// many other objects; from kTieScenes on it repeats.
std::string tie_scene(std::uint64_t number);
extern const std::uint64_t kTieScenes;

}  // namespace firstlight::golden
