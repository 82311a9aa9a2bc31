#pragma once

#include "render/math/color.h"
#include "render/scene/scene.h"
#include "render/surface/coat.h"
#include "render/surface/sky.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace firstlight::render {

/// A layer of a texture at some point: its pigment's colour there, and all that follows from it.
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
  double share_above = 1.0;                ///< of settled coats: what the layers above let through, as one number
  Rgb filter_above{1.0f, 1.0f, 1.0f};      ///< the same by colour
  LayerColor color;
  Rgb reflection{0.0f, 0.0f, 0.0f};
  float strongest = 0.0f;           ///< channel of a reflection, from the angle where it is most; prunes rays
  Rgb own_light{0.0f, 0.0f, 0.0f};  ///< of a white surface
  // Numbers of Finish, with 0 for those below 0:
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

/// Returns what goes on below a layer of the light that it lets through (`passed`): less by what it reflects where the
/// finish gives no more than it takes.
inline Rgb passed_below(const SurfaceLayer& layer, Rgb passed, const Rgb& reflection) {
  if (layer.reflects && layer.source->finish->conserve_energy) {
    const Rgb kept = Rgb(1.0f) - reflection;
    passed *= Rgb(std::min(1.0f, kept.x), std::min(1.0f, kept.y), std::min(1.0f, kept.z));
  }
  return passed;
}

/// A filter as one number, at most 1: layers below too small a share are not looked at. [POV-Ray 3.7]
inline double share_of(const Rgb& filter) {
  return is_black(filter) ? 0.0 : std::min(1.0, static_cast<double>(std::abs(grey(filter))));
}

/// All textures of a scene, compiled.
///
/// Meaning  A texture has one meaning, which shading, feelers and limits ask here, for many points at once.
/// Memory   Some 400 bytes a layer; a texture that stands in many places is compiled once.
/// Threads  Immutable.
class SurfaceTable {
 public:
  /// Pre: `scene` outlives this, unchanged.
  explicit SurfaceTable(const Scene& scene);

  /// The surroundings of all surfaces.
  const Sky& sky() const { return sky_; }

  /// The texture's one coat if it is even, else null. `texture`: index into Scene::textures.
  const Coat* even_coat(std::uint32_t texture) const { return even_[texture]; }
  /// The same if it is settled.
  const Coat* settled_coat(std::uint32_t texture) const { return settled_[texture]; }
  /// Whether a part of the scene may have highlights, as far as its outer texture tells.
  bool is_glossy(std::uint32_t part) const { return glossy_[part] != 0; }
  /// Whether it asks for the surface's own coordinates: SurfacePoints::uv.
  bool goes_by_uv(std::uint32_t texture) const { return nodes_[roots_[texture]].by_uv; }
  /// Whether it asks for more of the surface than the point alone: SurfacePoints::on_surface.
  bool goes_by_surface(std::uint32_t texture) const { return nodes_[roots_[texture]].by_surface; }
  /// Topmost first.
  std::span<const SurfaceLayer> layers(const Coat& coat) const { return {layers_.data() + coat.first, coat.count}; }
  /// All that any texture is made of.
  const std::deque<Coat>& coats() const { return coats_; }
  std::span<const SurfaceLayer> all_layers() const { return layers_; }
  /// The layer's colour where its pigment is `pigment`.
  LayerColor color(const SurfaceLayer& layer, const FilteredColor& pigment) const;

  /// Appends the coats that a texture shows at `points`, given in the scene, in the order of its maps.
  void unfold(std::uint32_t texture, const SurfacePoints& points, CoatList& coats) const;
  /// Finds the layer's look at the coat's points. Leaves its normals in points.tilted.
  void look(const SurfaceLayer& layer, CoatPoints& points, LayerLook& look) const;
  /// Multiplies light by what passes the texture, if that is the same everywhere; else returns false.
  bool filter_evenly(std::uint32_t texture, Rgb& light) const {
    const Coat* const coat = even_coat(texture);
    if (coat == nullptr) return false;
    for (const SurfaceLayer& layer : layers(*coat)) light *= layer.color.passed;
    return true;
  }
  /// Multiplies light[i] by what passes the texture at point i, given in the scene. `caustics`: of the interior; not 0:
  /// light is gathered where it falls steeply, so that more may pass than came. Pre: then the points are on the surface.
  /// `scratch`: what it holds is lost.
  void filter(std::uint32_t texture, const SurfacePoints& points, std::span<Rgb> light, CoatList& scratch,
              double caustics = 0.0) const;

 private:
  /// A texture or a part of one: a coat, or a pattern of such.
  struct Node {
    const Coat* coat = nullptr;
    std::optional<CompiledPattern> pattern;
    bool keeps_length = false;
    bool by_uv = false;                                     ///< it or a part of it
    bool by_surface = false;                                ///< likewise
    std::vector<std::pair<double, std::uint32_t>> entries;  ///< position or weight, node
  };
  /// On the way down.
  struct Way {
    std::vector<NormalSpace> spaces;
    const Transform* placement = nullptr;  ///< from what is around it to the space at hand
  };

  std::uint32_t compile(const Texture& texture);
  SurfaceLayer prepared(const TextureLayer& layer);
  void settle(Coat& coat);
  bool has_gloss(std::uint32_t node) const;
  void filter_by(CoatPoints& coat, std::span<Rgb> light, double caustics) const;
  /// One coat more, at all of `points`, which lie at `at` in its space.
  static void add_coat(const Node& node, const Way& way, const SurfacePoints& points, const Columns3<double>& at,
                       const std::array<std::uint8_t, kRaysAtOnce>& lanes, const Column<double>& shares,
                       CoatList& coats);
  void unfold_node(const Node& node, const Way& way, const SurfacePoints& points,
                   const std::array<std::uint8_t, kRaysAtOnce>& lanes, const Column<double>& shares,
                   CoatList& coats) const;

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
  std::vector<const Coat*> settled_;
  std::vector<std::uint8_t> glossy_;
};

}  // namespace firstlight::render
