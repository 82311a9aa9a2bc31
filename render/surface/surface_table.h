#pragma once

#include "render/math/color.h"
#include "render/scene/scene.h"
#include "render/surface/compiled_normal.h"
#include "render/surface/compiled_pigment.h"
#include "render/surface/sky.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
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
  const CompiledPigment* pigment = nullptr;
  const CompiledNormal* normal = nullptr;  ///< null: even
  bool is_plain = false;                   ///< one colour everywhere: `color`
  bool reflects = false;                   ///< anything, from some angle
  bool is_even_mirror = false;             ///< reflects alike from all angles: `reflection`
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
  double crand = 0.0;
  double irid = 0.0;
};

/// Layers that lie on each other, topmost first: a texture that is not made of other textures.
struct Coat {
  std::size_t first = 0;  ///< of SurfaceTable::layers
  std::size_t count = 0;
  bool is_even = true;    ///< looks the same everywhere, and tilts no normals
  bool is_glossy = false;
};

/// Points at which one coat is to be asked: those where a texture shows it.
struct CoatPoints {
  const Coat* coat = nullptr;
  std::vector<NormalSpace> spaces;         ///< that normals pass on the way to the coat's own space, the outermost first
  const Transform* placement = nullptr;    ///< from the last of them, or from the scene, to that space
  SurfacePoints points;                    ///< `at` in the coat's space
  std::array<std::uint8_t, kRaysAtOnce> lane;  ///< of each: the point of the texture that it stands for
  Column<double> share;                    ///< of the texture, that the coat is there
};

/// What a layer of a coat is at its points.
struct LayerLook {
  ColorColumns colors;
  Columns3<double> normals;  ///< of layers that have a normal; unit, in the scene
};

/// All textures of a scene, compiled.
///
/// Meaning  A texture has one meaning, which shading, feelers and limits ask here, for many points at once.
/// Memory   Some 400 bytes a layer; a texture that stands in many places is compiled once.
/// Threads  Immutable.
class SurfaceTable {
 public:
  /// Pre: `scene` outlives this, unchanged.
  explicit SurfaceTable(const Scene& scene);

  /// What is around all surfaces.
  const Sky& sky() const { return sky_; }

  /// The texture's one coat if it is even, else null. `texture`: index into Scene::textures.
  const Coat* even_coat(std::uint32_t texture) const { return even_[texture]; }
  /// Whether any layer has highlights.
  bool is_glossy(std::uint32_t texture) const { return glossy_[texture] != 0; }
  /// Whether it asks for the surface's own coordinates: SurfacePoints::u and v.
  bool goes_by_uv(std::uint32_t texture) const { return nodes_[roots_[texture]].by_uv; }
  /// Topmost first.
  std::span<const SurfaceLayer> layers(const Coat& coat) const { return {layers_.data() + coat.first, coat.count}; }
  /// The layer's colour where its pigment is `pigment`.
  LayerColor color(const SurfaceLayer& layer, const FilteredColor& pigment) const;

  /// Appends the coats that a texture shows at `points`, given in the scene, in the order of its maps.
  void unfold(std::uint32_t texture, const SurfacePoints& points, std::vector<std::unique_ptr<CoatPoints>>& coats) const;
  /// What the layer is at the coat's points. It leaves its normals in points.tilted.
  void look(const SurfaceLayer& layer, CoatPoints& points, LayerLook& look) const;
  /// Multiplies light[i] by what passes the texture at point i, given in the scene. `caustics`: of the interior; not 0:
  /// light is gathered where it falls steeply, so that more may pass than came. Pre: then the points are on the surface.
  void filter(std::uint32_t texture, const SurfacePoints& points, std::span<Rgb> light, double caustics = 0.0) const;

 private:
  /// A texture or a part of one: a coat, or a pattern of such.
  struct Node {
    const Coat* coat = nullptr;
    std::optional<CompiledPattern> pattern;
    bool keeps_length = false;
    bool by_uv = false;  ///< it or a part of it
    std::vector<std::pair<double, std::uint32_t>> entries;  ///< position or weight, node
  };
  /// On the way down.
  struct Way {
    std::vector<NormalSpace> spaces;
    const Transform* placement = nullptr;  ///< from what is around it to the space at hand
  };

  std::uint32_t compile(const Texture& texture);
  SurfaceLayer prepared(const TextureLayer& layer);
  bool has_gloss(std::uint32_t node) const;
  void filter_by(CoatPoints& coat, std::span<Rgb> light, double caustics) const;
  void unfold_node(const Node& node, const Way& way, const SurfacePoints& points,
                   const std::array<std::uint8_t, kRaysAtOnce>& lanes, const Column<double>& shares,
                   std::vector<std::unique_ptr<CoatPoints>>& coats) const;

  const Scene* scene_;
  PatternWorld world_;
  Sky sky_;
  bool old_opacity_ = false;
  Rgb ambient_light_;
  std::vector<SurfaceLayer> layers_;
  std::deque<CompiledPigment> pigments_;
  std::deque<CompiledNormal> normals_;
  std::deque<Coat> coats_;
  std::deque<Node> nodes_;
  std::unordered_map<const Texture*, std::uint32_t> node_of_;
  std::vector<std::uint32_t> roots_;  // of each texture of the scene: its node
  std::vector<const Coat*> even_;
  std::vector<std::uint8_t> glossy_;
};

}  // namespace firstlight::render
