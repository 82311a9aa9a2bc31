#pragma once

#include "render/camera/camera.h"
#include "render/light/light.h"
#include "render/math/color.h"
#include "render/math/shared.h"
#include "render/scene/atmosphere.h"
#include "render/scene/cutaway.h"
#include "render/scene/global_settings.h"
#include "render/scene/object_group.h"
#include "render/scene/quality.h"
#include "render/scene/solid.h"
#include "render/texture/interior.h"
#include "render/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace firstlight::render {

/// A texture where it is used. `to_texture` takes world points into the texture's space.
struct PlacedTexture {
  TexturePtr texture;
  Transform to_texture;
};

constexpr std::uint32_t kNoIndex = 0xffffffffu;

/// One primitive's surface: what shading needs once a ray has met it.
struct Part {
  std::uint32_t texture = kNoIndex;           ///< into Scene::textures; kNoIndex: takes the light but gives none
  std::uint32_t interior_texture = kNoIndex;  ///< seen against the normal; kNoIndex: as `texture`
  std::uint32_t interior = 0;                 ///< into Scene::interiors; equal for all parts of one piece of matter
  std::uint32_t object = 0;                   ///< into Scene::objects: what a user may call it
  std::uint32_t shape_textures = 0;           ///< into Scene::shape_textures: the first of the shape's own list
  std::uint32_t cutaway = kNoIndex;           ///< into Scene::cutaways: where it has no texture, who has
  bool has_shape_textures = false;            ///< the shape says which textures are seen at a point, or `cutaway` does
  bool uv_mapping = false;                    ///< textures lie in the surface's own coordinates
  bool opaque = false;                        ///< no light passes, from either side
  bool inverted = false;
  bool double_illuminate = false;
  bool global_lights = true;      ///< lights that are in no group shine on it
  std::uint32_t light_group = 0;  ///< whose lights shine on it, too; 0: none
};

/// Whether the light shines on the part: it does not, if it belongs to another light group.
inline bool shines_on(const Light& light, const Part& part) {
  return light.group == 0 ? part.global_lights : light.group == part.light_group;
}

/// The meaning of the scene's colour numbers (assumed_gamma), which decides how the finished picture is written.
enum class WorkingGamma {
  linear,     ///< proportional to light; the file gets the sRGB curve
  power,      ///< light ^ (1 / gamma_exponent); the file gets what makes the same light on an sRGB display
  srgb,       ///< already on the sRGB curve; written as they are
  unmanaged,  ///< old scenes without assumed_gamma: written as they are
};

/// global_settings and what else holds for the whole picture. Defaults are POV-Ray 3.7's.
struct Settings {
  Rgb ambient_light{1.0f, 1.0f, 1.0f};
  int max_trace_level = 5;
  double adc_bailout = 1.0 / 255.0;
  Rgb background{0.0f, 0.0f, 0.0f};
  FilteredColor background_with_alpha{Rgb(0.0f), 0.0f, 1.0f};  ///< instead, of a picture with an alpha channel
  double atmosphere_ior = 1.0;
  int language_version = 370;  ///< as 100 * version; some formulas of transparency differ before 370
  WorkingGamma gamma = WorkingGamma::linear;
  double gamma_exponent = 1.0;  ///< of WorkingGamma::power
  Charset charset = Charset::ascii;
  Rgb irid_wavelength{0.70f, 0.52f, 0.48f};
  int number_of_waves = 10;  ///< of the patterns `waves` and `ripples`
  Quality quality;
  double mm_per_unit = 10.0;  ///< for light below surfaces
  RadiositySettings radiosity = {};
  PhotonSettings photons = {};
  SubsurfaceSettings subsurface = {};
  int noise_generator = 2;  ///< 1 to 3, of functions and of patterns that choose none
  FeatureUses unrendered = {};
};

/// Everything to be rendered, frozen. Plain data, safe to read from any thread.
struct Scene {
  Settings settings;
  Camera camera;
  Atmosphere atmosphere;
  std::vector<Light> lights;
  /// Top-level solids in the order of the scene text, which has a part in who is seen of those in one place.
  std::vector<Solid> solids;
  std::vector<Part> parts;
  std::vector<Solid> windows;  ///< what lights are projected through: it is met by no ray, and has no surface
  std::vector<PlacedTexture> textures;
  std::vector<std::uint32_t> shape_textures;  ///< the lists of all shapes that have some, into `textures`
  std::vector<Shared<Interior>> interiors;
  std::vector<Cutaway> cutaways;
  std::vector<ObjectGroup> objects;
  FeatureUses unrendered = {};  ///< of all that is in the scene: while not empty, no picture is right
  std::vector<std::vector<std::string>> light_names;  ///< SDL identifiers of each light, the outermost first
};

}  // namespace firstlight::render
