#pragma once

#include "render/accel/accel.h"
#include "render/math/fixed_rgb.h"
#include "render/scene/scene.h"
#include "render/surface/sky.h"
#include "render/surface/surface_table.h"
#include "render/trace/area_shadow.h"
#include "render/trace/hit_block.h"
#include "render/trace/medium_table.h"
#include "render/trace/radiance_bound.h"
#include "render/trace/ray_counts.h"
#include "render/trace/ray_task.h"
#include "render/trace/shadow.h"
#include "render/trace/trace_context.h"
#include "render/trace/veil.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace firstlight::render {

/// One worker's tracing step: nearest hits of a batch of tasks, then local shading. It never recurses along a ray tree
/// and never traces a feeler it spawns.
///
/// Sum rule  pixel = sum over tasks of task.weight * local, so child.weight = task.weight * factor. Lights are added as
///           if unoccluded; a shadow child carries what it must take back when it is blocked.
/// Source    Yagel & Meeker 1997, eq. 3-9; the local terms, weights and levels are POV-Ray 3.7's.
/// Order     The contributions and tasks of a batch do not depend on how tasks are grouped into batches.
/// Ends      While an Interrupt lives, early when it is asked to: what a step then brings is of no use.
/// Threads   One Stepper a thread.
class Stepper {
 public:
  explicit Stepper(const TraceContext& context) : Stepper(context, std::make_shared<SurfaceTable>(context.scene)) {}
  /// `surfaces`: of the scene, shared between steppers.
  Stepper(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces);
  Stepper(const Stepper&) = delete;  // its parts refer to each other
  Stepper& operator=(const Stepper&) = delete;

  /// Traces `tasks`, replacing light() and spawned() by what comes of them. Pre: `tasks` is not spawned() itself.
  void step(std::span<const RayTask> tasks);
  /// The same for primary tasks, along rays given in full precision. Pre: equal sizes.
  void step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays);

  std::span<const Contribution> light() const { return light_; }
  /// Additions to what shows through, where the context asks for it.
  std::span<const Clearness> clearness() const { return clearness_; }
  std::span<const RayTask> spawned() const { return spawned_; }
  /// Since construction.
  const RayCounts& counts() const { return counts_; }

 private:
  /// A layer of a texture that was met and reflects.
  struct Mirror {
    const SurfaceLayer* layer;
    Rgb reflection;
    std::uint32_t column;  ///< of HitBlock::layers
    double adc_weight;
  };
  /// A hit, as far as rays that it sends on need it; the HitBlock has the rest, under the same number.
  struct Surface {
    const RayTask* task;
    const Part* part;
    Contribution* sum;  ///< of the task
    Rgb weight;         ///< of the task, less what the way to the surface takes
    float clear;        ///< the same of what shows through
    Rgb own_light;
    std::int32_t level;         ///< of everything spawned here
    std::uint32_t layer_count;  ///< in the HitBlock's columns
    std::size_t open_record;    ///< of feelers, that may take more; kNoRecord: none
  };
  /// One coat of a hit: what its layers do together to rays that go on.
  struct Coating {
    std::uint32_t hit;
    std::uint32_t column;  ///< of HitBlock::layers: its topmost layer
    Rgb weight;            ///< of the ray, times the coat's share of the texture
    float clear;           ///< the same of what shows through
    Rgb filter;            ///< what all layers let through
    double share;          ///< the same as one number; 0 where nothing passes
    std::uint32_t first_mirror;
    std::uint32_t mirror_count;
  };
  /// A hit whose texture has to be asked at its point.
  struct Uneven {
    std::uint32_t texture;
    std::uint8_t hit;
    double share;  ///< of how the hit looks
  };
  static constexpr std::size_t kNoRecord = ~std::size_t{0};

  void begin(std::span<const RayTask> tasks);
  /// At most kRaysAtOnce tasks, whose contributions go to `light`; `rays` are those of `tasks`, empty: to be unpacked
  /// from the tasks.
  void step_radiance(std::span<const RayTask> tasks, std::span<const Ray> rays, std::span<Contribution> light);
  void step_shadow(std::span<const RayTask> tasks, std::span<Contribution> light);

  /// Adds what the rays of rays_ see of their surroundings: what lies along the way to hits_ and the sky behind. Sets
  /// veils_.
  void see_surroundings(std::span<const RayTask> tasks, std::span<Contribution> light);
  /// The sky, for those of `misses` that do not ask what shows through it, and for those that do.
  void see_sky(std::span<const RayTask> tasks, std::uint64_t misses, std::span<Contribution> light);
  void see_through_sky(std::span<const RayTask> tasks, std::uint64_t misses, std::span<Contribution> light);
  /// Returns how many these rays' directions are.
  std::size_t gather_directions(std::uint64_t rays, Columns3<double>& directions) const;
  /// A ray's weight for light, less what the way to what it meets takes, and that for what shows through.
  Rgb light_weight(const RayTask& task, std::size_t ray) const;
  float clear_weight(const RayTask& task, std::size_t ray) const;

  /// Adds what the feelers of a record change, from number `feeler` of the block on; `blocked` are the bits of those
  /// that something opaque blocks.
  void take_back(const RayTask& task, std::size_t& feeler, std::uint64_t blocked, std::uint64_t to_areas,
                 Contribution& light);
  /// Shortens feelers to lights that are projected through something, whose ways end there. Returns the bits of those
  /// that do not lead through it.
  std::uint64_t end_at_windows(std::span<const RayTask> tasks);
  /// Finds what passes of the light of those feelers of the block that lead to area lights, and keeps it in shares_;
  /// the others' shares are what they were. Returns the bits of those feelers.
  std::uint64_t ask_areas(std::span<const RayTask> tasks);

  /// The same of those whose bit is set in `open`, which meet nothing opaque.
  void ask_passing(std::span<const RayTask> tasks, std::uint64_t open);

  /// Writes what these rays of rays_ meet behind the hits of block_, with the normals that the shapes have; those that
  /// meet one shape after each other ask it once.
  void find_normals(std::span<const std::uint8_t> rays);
  /// Adds the hit of a ray of rays_, which was written there at `place`, to block_ and surfaces_, unless it takes the
  /// light and gives none. Pre: places come in their order.
  void meet(std::size_t place, std::size_t ray, const RayTask& task, Contribution& sum);
  /// One texture of a hit, and its share of how the hit looks.
  void wear(std::size_t hit, std::uint32_t texture, double share);
  /// The textures of hits on shapes with lists of their own.
  void wear_own_textures();
  /// Asks textures that differ from point to point, each for all of its hits.
  void meet_uneven();
  /// Sets asked_ to the points of these hits.
  void ask_uneven(std::uint32_t texture, std::span<const Uneven> hits);
  /// Lays a settled coat on a hit.
  void put_on(std::size_t hit, const Coat& coat, double share);
  /// Lays any coat on a hit; looks_ has its layers, at point `lane`.
  void put_on_uneven(std::size_t hit, const Coat& coat, double share, std::size_t lane);
  /// One more of coatings_, from here on in the columns and mirrors.
  Coating& begin_coating(std::size_t hit, double share);
  /// The columns of one more layer of the hit.
  std::uint32_t next_column(Surface& surface);
  /// `share`: the ray's weight, and what the layers above let through.
  void lay(std::uint32_t column, std::size_t hit, const SurfaceLayer& layer, const LayerColor& color, const Rgb& share);
  /// Lights all that was met, and lets it send on its rays.
  void shade();
  /// Which hits the lights may shine on, where some are in groups.
  void find_reached(std::span<const Light> lights);
  void spawn_feelers(std::uint32_t first_light, std::size_t light_count);
  void add_feeler(std::size_t hit, std::uint32_t light, PackedRgb at_stake);
  /// Returns true where the ray cannot leave and is reflected instead (total internal reflection).
  bool spawn_transmission(const Coating& coating);
  /// The matter that a ray passes into at a hit, and how the ray is bent there.
  struct Passage {
    std::uint32_t medium;
    double ior;         ///< of the side the ray comes from, relative to the side it goes to
    double dispersion;  ///< the same
    int bands;          ///< that white light is split into, if there is dispersion
  };
  Passage passage_of(const Surface& surface) const;
  /// Sends the child the way of its refraction; returns true where it is reflected instead.
  bool bend(const Coating& coating, double ior, RayTask& child) const;
  /// A ray for each band.
  void spawn_bands(const Coating& coating, const Passage& passage, const Rgb& weight);
  /// `totally`: the coat reflects all by its topmost normal, so that mirrors of this normal have no part.
  void spawn_reflections(const Coating& coating, bool totally);
  /// The colour that a thin film on the mirror makes of white light that comes from where it reflects.
  Rgb film_color(std::size_t hit, const Mirror& mirror, PackedDirection reflected) const;
  /// The layer's normal at a hit.
  Vec3 normal_at(std::size_t hit, std::uint32_t column) const;
  bool is_tilted(std::size_t hit, std::uint32_t column) const {
    return column < block_->layer_count && (block_->layers[column].tilted >> hit & 1u) != 0;
  }
  /// Where a ray goes that a tilted normal reflects.
  Vec3 reflected_by(std::size_t hit, const Vec3& normal) const;
  /// `steepness`: minus the cosine of the ray to the layer's normal; even mirrors do not ask for it.
  Rgb reflectivity(const Surface& surface, double steepness, const SurfaceLayer& layer, const Rgb& color,
                   double& adc_weight) const;
  double relative_ior(const Surface& surface) const;

  /// Sets what all rays that leave a hit have in common.
  void begin_child(RayTask& child, std::size_t hit, RayKind kind) const;
  /// Adds what the last of spawned_ may bring, or takes it away if that is nothing.
  void end_ray(const Surface& surface);
  /// Adds weight * colour(root) ^ exponent: not a sum over rays, so the subtree is evaluated here, depth first.
  void add_sealed(const Surface& surface, RayTask root, double exponent);
  Rgb trace_sealed(const RayTask& root);

  TraceContext context_;
  std::shared_ptr<const SurfaceTable> table_;
  Veils veils_of_scene_;
  RadianceBound bound_;
  Shadow shadow_;
  std::unique_ptr<AreaShadow> area_shadow_;  ///< null: there are no area lights
  std::vector<LightPlace> light_places_;
  bool has_light_groups_ = false;
  bool has_two_sided_light_ = false;
  std::unique_ptr<RayBlock> rays_;
  Column<std::int64_t> packed_directions_;
  std::array<Hit, kRaysAtOnce> hits_;
  std::array<Veil, kRaysAtOnce> veils_;        ///< of each ray, where the scene has any
  std::array<Surface, kRaysAtOnce> surfaces_;  ///< block_->size of them
  std::vector<Mirror> mirrors_;
  std::vector<Coating> coatings_;
  std::vector<Uneven> uneven_;
  std::uint64_t own_textures_ = 0;  ///< bits of hits on shapes with lists of their own
  std::vector<TextureShare> worn_;
  Columns2<double> uvs_;  ///< of hits with textures that ask for them
  std::unique_ptr<SurfacePoints> asked_;
  CoatList coats_;
  std::vector<LayerLook> looks_;
  std::unique_ptr<HitBlock> block_;
  std::unique_ptr<FeelerBlock> feelers_;
  std::array<Rgb, kRaysAtOnce> shares_;  ///< of the block's feelers, where they are asked for
  std::vector<Contribution> light_;
  std::vector<Clearness> clearness_;
  std::vector<RayTask> spawned_;
  std::unique_ptr<Stepper> sealed_;  ///< made when first needed
  RayCounts counts_;
};

inline Rgb Stepper::light_weight(const RayTask& task, std::size_t ray) const {
  if ((task.flags & RayTask::kSeesThrough) != 0) return Rgb(0.0f);
  return veils_of_scene_.empty() ? task.weight() : task.weight() * veils_[ray].kept;
}

inline float Stepper::clear_weight(const RayTask& task, std::size_t ray) const {
  if (!context_.with_alpha) return 0.0f;
  const bool asks = task.kind == RayKind::primary || (task.flags & RayTask::kSeesThrough) != 0;
  if (!asks) return 0.0f;
  return veils_of_scene_.empty() ? task.weight().x : task.weight().x * veils_[ray].clear;
}

/// Whether POV-Ray would trace the task at all (max_trace_level, adc_bailout); others add nothing.
inline bool is_worth_tracing(const Settings& settings, const RayTask& task) {
  return task.level < settings.max_trace_level && !(task.adc_weight() < settings.adc_bailout);
}

}  // namespace firstlight::render
