#pragma once

#include "render/math/color.h"
#include "render/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// What a layer of a texture is at some point: its pigment's colour there, and all that follows from it.
struct LayerColor {
  Rgb rgb{0.0f, 0.0f, 0.0f};
  Rgb own_light{0.0f, 0.0f, 0.0f};  ///< ambient and emission
  Rgb passed{0.0f, 0.0f, 0.0f};     ///< share of the light that goes on to what lies below
  double opacity = 1.0;             ///< share of the light that is left for this layer
};

/// A layer of a texture, made ready for shading: what is the same at every point, and seen from everywhere, is worked
/// out.
struct SurfaceLayer {
  const TextureLayer* source = nullptr;
  bool is_plain = false;        ///< one colour everywhere: `color`
  bool reflects = false;        ///< anything, from some angle
  bool is_even_mirror = false;  ///< reflects alike from all angles: `reflection`
  LayerColor color;
  Rgb reflection{0.0f, 0.0f, 0.0f};
  float strongest = 0.0f;           ///< channel of a reflection, from the angle where it is most; prunes rays
  Rgb own_light{0.0f, 0.0f, 0.0f};  ///< of a white surface
  // Of Finish, without what is less than nothing.
  double diffuse = 0.0;
  double specular = 0.0;
  double specular_exponent = 0.0;
  bool has_rare = false;  ///< any of what follows is not as it is here
  double diffuse_back = 0.0;
  double brilliance = 1.0;
  double phong = 0.0;
  double phong_size = 0.0;
  double metallic = 0.0;
};

/// All layers of all textures of a scene.
///
/// Memory   some 200 bytes a layer.
/// Threads  Immutable.
class SurfaceTable {
 public:
  /// Pre: `scene` outlives this, unchanged.
  explicit SurfaceTable(const Scene& scene);

  /// Topmost first. `texture`: index into Scene::textures.
  std::span<const SurfaceLayer> layers(std::uint32_t texture) const {
    return {layers_.data() + first_[texture], layers_.data() + first_[texture + 1]};
  }
  /// Whether any layer has highlights.
  bool is_glossy(std::uint32_t texture) const { return glossy_[texture] != 0; }
  /// The layer's colour where its pigment is `pigment`.
  LayerColor color(const SurfaceLayer& layer, const FilteredColor& pigment) const;

 private:
  SurfaceLayer prepared(const TextureLayer& layer) const;

  bool old_opacity_ = false;
  Rgb ambient_light_;
  std::vector<SurfaceLayer> layers_;
  std::vector<std::size_t> first_;  // of each texture, and one beyond the last
  std::vector<std::uint8_t> glossy_;
};

}  // namespace firstlight::render
