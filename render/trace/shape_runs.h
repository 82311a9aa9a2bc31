#pragma once

#include "render/shape/shape.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace firstlight::render {

/// Calls ask(shape, first, end) for each run of places, one after the other, of one shape, among those whose bits are set.
template <class Ask>
void for_each_run(const SurfacePlaces& places, std::uint64_t which, const Ask& ask) {
  while (which != 0) {
    const auto first = static_cast<std::size_t>(std::countr_zero(which));
    const Shape* const shape = places.crossing[first]->shape;
    std::size_t end = first;
    do {
      which &= ~(std::uint64_t{1} << end);
      ++end;
    } while (end < kRaysAtOnce && (which >> end & 1u) != 0 && places.crossing[end]->shape == shape);
    ask(*shape, first, end);
  }
}

}  // namespace firstlight::render
