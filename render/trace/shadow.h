#pragma once

#include "render/accel/accel.h"
#include "render/math/color.h"
#include "render/scene/scene.h"
#include "render/surface/surface_table.h"
#include "render/trace/medium_table.h"
#include "render/trace/see_through.h"
#include "render/trace/trace_context.h"
#include "render/trace/veil.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::render {

/// Finds how much light passes along straight ways between surfaces and lights.
///
/// Source   POV-Ray 3.7: what filters and what is clear in the layers of what is met, and what fades inside of matter.
/// Threads  One a thread.
class Shadow {
 public:
  /// Pre: `surfaces` and `veils` outlive it.
  Shadow(const TraceContext& context, const SurfaceTable& surfaces, const Veils& veils);

  /// False where of all light either nothing is taken or everything.
  bool takes_parts() const { return takes_parts_; }
  /// Ends the ray to a light that is projected through something at that window: nothing beyond casts a shadow, nor
  /// does anything if the light is without shadow. False where the ray does not lead through it. `max_depth`: to the
  /// light.
  bool end_at_window(const Light& light, const Ray& ray, double& max_depth);
  /// Finds the share that passes of the light along each of the rays, from their least depth to their largest. `media`:
  /// what their origins are in; `lights`: by number. Pre: equal sizes.
  void passing(const RayBlock& rays, std::span<const std::uint32_t> media, std::span<const std::uint32_t> lights,
               std::span<Rgb> shares);
  /// The same of those rays whose bit is set in `open`, which meet nothing opaque; the others' shares stay. Pre:
  /// takes_parts().
  void pass_surfaces(const RayBlock& rays, std::uint64_t open, std::span<const std::uint32_t> media,
                     std::span<const std::uint32_t> lights, std::span<Rgb> shares);

 private:
  /// The rest of a ray's way to its light, and the rest of the light.
  struct Way {
    std::size_t number;  ///< of the ray
    Ray ray;
    double distance;
    std::uint32_t medium;  ///< that it is in
    bool through_fog;      ///< fog weakens the light
    Rgb passed;
  };

  /// Leaves those of ways_ that `keep` says.
  template <class Keep>
  void keep_ways(const Keep& keep);
  /// A texture that a way leads through.
  struct Filter {
    std::uint32_t texture;
    std::uint8_t way;  ///< of ways_, and of met_
    bool follows_uv;   ///< its part is mapped by the surface's own coordinates
    double share;      ///< of how the surface looks there
    double caustics;   ///< of the interior
    Rgb passed;        ///< of the light that comes there; of white light where textures share the surface
  };

  /// Takes the rays of ways_ through the surfaces of met_.
  void pass();
  void pass_fog(Way& way, double depth) const;
  /// The share that is left at the end of the way.
  Rgb arriving(Way& way) const;
  /// Takes from the light of ways_ what the surfaces of met_ keep. Returns bits of those that have a texture.
  std::uint64_t filter_light();
  /// Bits of ways.
  struct Sides {
    std::uint64_t done = 0;    ///< through one texture that is even, which has had its part already and is no filter
    std::uint64_t shared = 0;  ///< through surfaces that several textures may share: Part::has_shape_textures
  };
  /// Sets filters_ to what the surfaces wear, and normals_ and uvs_ to what those ask for.
  Sides find_filters();
  /// Sets what passes filters of one texture and of equal caustics, at most kRaysAtOnce, by number.
  void ask_filters(std::span<const std::uint32_t> numbers);
  const Part& part_at(std::size_t way) const { return context_.scene.parts[met_->crossing[way]->part]; }

  TraceContext context_;
  const SurfaceTable& surfaces_;
  const Veils& veils_;
  bool takes_parts_;
  SeeThrough see_through_;
  std::unique_ptr<SurfacePlaces> met_;  ///< by each of ways_
  Columns3<double> normals_;            ///< of met_, where they are asked for
  Columns2<double> uvs_;                ///< likewise
  std::vector<Filter> filters_;
  std::vector<std::uint32_t> order_;  ///< of those of filters_ that are to be asked, by texture
  std::unique_ptr<SurfacePoints> asked_;
  CoatList coats_;
  std::vector<TextureShare> worn_;
  std::vector<Way> ways_;
  std::unique_ptr<RayBlock> block_;
  std::array<Hit, kRaysAtOnce> hits_;
  std::vector<Crossing> crossings_;  ///< of a window
};

}  // namespace firstlight::render
