#pragma once

#include <cstdint>

namespace firstlight::render {

// Chance that belongs to places of a picture, the same in every run. Values are POV-Ray 3.7's.

/// Entry `index`, modulo 4096, of a shuffle of the numbers below 4096.
std::uint32_t shuffled(std::uint32_t index);

/// Two numbers from -1/2 to 1/2.
struct PlaceJitter {
  double x;
  double y;
};
/// Those of a place, in pixels; places nearer than 1/1021 of a pixel mostly have the same.
PlaceJitter place_jitter(double x, double y);

}  // namespace firstlight::render
