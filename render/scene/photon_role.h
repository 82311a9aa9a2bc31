#pragma once

#include <optional>

namespace firstlight::render {

/// The part of an object, or a light, in the tracing of photons. Without photons in the scene it means nothing.
/// Source   POV-Ray 3.7 manual, "Photons".
struct PhotonRole {
  double target = 0.0;                  ///< factor on the distance of the photons shot at the object; 0: none are
  std::optional<bool> reflection = {};  ///< not given: photons that are shot at something else are not reflected
  std::optional<bool> refraction = {};
  bool pass_through = false;  ///< photons go through as if it were not there
  bool collect = true;        ///< photons are stored on its surface
};

}  // namespace firstlight::render
