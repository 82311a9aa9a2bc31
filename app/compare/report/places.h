#pragma once

#include "render/image/picture.h"

#include <array>
#include <cstddef>
#include <vector>

namespace firstlight::app::compare {

/// A pixel in which two pictures differ.
struct Place {
  int x = 0, y = 0;
  int difference = 0;  ///< the largest of a channel, of 255
  std::array<int, 3> first{}, second{};
};

/// The pixels that differ most, of each square of 16 pixels at most one, the worst first. Pre: equal sizes.
std::vector<Place> worst_places(const render::Picture& first, const render::Picture& second, std::size_t most);

}  // namespace firstlight::app::compare
