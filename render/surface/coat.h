#pragma once

#include "render/math/transform.h"
#include "render/surface/compiled_normal.h"
#include "render/surface/compiled_pigment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

/// The layers of a coat that looks the same everywhere, taken together, where no angle of sight changes it.
struct SettledCoat {
  std::size_t seen = 0;             ///< layers from the topmost on, before the light that is left is too little
  double share = 1.0;               ///< of the light, what passes them all
  Rgb filter{1.0f, 1.0f, 1.0f};     ///< the same by colour
  Rgb own_light{0.0f, 0.0f, 0.0f};  ///< of all layers, as it leaves the topmost
};

/// Layers that lie on each other, topmost first: a texture that is not made of other textures.
struct Coat {
  std::size_t first = 0;  ///< of SurfaceTable::layers
  std::size_t count = 0;
  bool is_even = true;     ///< looks the same everywhere, and tilts no normals
  bool is_settled = true;  ///< even, and no layer's reflection leaves the next one light by the angle of sight
  bool is_glossy = false;
  bool is_opaque = false;    ///< no light passes it anywhere
  SettledCoat settled = {};  ///< of settled ones
};

/// Points at which one coat is to be asked: those where a texture shows it.
struct CoatPoints {
  const Coat* coat = nullptr;
  std::vector<NormalSpace> spaces;       ///< that normals pass on the way to the coat's own space, the outermost first
  const Transform* placement = nullptr;  ///< from the last of them, or from the scene, to that space
  SurfacePoints points;                  ///< `at` in the coat's space
  std::array<std::uint8_t, kRaysAtOnce> lane;  ///< of each: the point of the texture that it stands for
  Column<double> share;                        ///< of the texture, that the coat is there
};

/// The coats that a texture shows at some points, in the order of its maps. Cleared, it keeps its memory for the next
/// points.
class CoatList {
 public:
  /// One more; what it holds is for the caller to set.
  CoatPoints& add() {
    if (size_ == coats_.size()) coats_.push_back(std::make_unique_for_overwrite<CoatPoints>());
    return *coats_[size_++];
  }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  CoatPoints& operator[](std::size_t i) { return *coats_[i]; }

 private:
  std::vector<std::unique_ptr<CoatPoints>> coats_;
  std::size_t size_ = 0;
};

/// The look of a coat's layer at the coat's points.
struct LayerLook {
  ColorColumns colors;
  Columns3<double> normals;  ///< of layers that have a normal; unit, in the scene
};

}  // namespace firstlight::render
