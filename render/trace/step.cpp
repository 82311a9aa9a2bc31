#include "render/trace/step.h"

#include "render/camera/camera.h"
#include "render/lanes/math.h"
#include "render/math/interrupt.h"
#include "render/trace/surface_limits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace firstlight::render {
namespace {

// POV-Ray 3.7's distances, in scene units: a radiance ray leaves its origin's surface behind at kNearestHit.
constexpr double kNearestHit = 1e-4;
constexpr double kFarthestHit = 1e17;
constexpr double kNegligible = 1e-10;

std::uint8_t hidden_bit(const RayTask& task) {
  if ((task.flags & RayTask::kReflected) != 0) return kHiddenFromReflection;
  return task.kind == RayKind::transmission ? kHiddenFromPrimary | kSentThrough : kHiddenFromPrimary;
}

}  // namespace

RayCounts& RayCounts::operator+=(const RayCounts& other) {
  for (std::size_t i = 0; i < by_kind.size(); ++i) by_kind[i] += other.by_kind[i];
  clear += other.clear;
  blocked += other.blocked;
  return *this;
}

RayCounts RayCounts::operator-(const RayCounts& before) const {
  RayCounts more;
  for (std::size_t i = 0; i < by_kind.size(); ++i) more.by_kind[i] = by_kind[i] - before.by_kind[i];
  more.clear = clear - before.clear;
  more.blocked = blocked - before.blocked;
  return more;
}

Stepper::Stepper(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces)
    : context_(context),
      table_(std::move(surfaces)),
      veils_of_scene_(context.scene),
      bound_(context.scene, context.camera(), *table_, context.with_alpha),
      shadow_(context, *table_, veils_of_scene_),
      rays_(std::make_unique<RayBlock>()),
      asked_(std::make_unique_for_overwrite<SurfacePoints>()),
      block_(std::make_unique<HitBlock>()),
      feelers_(std::make_unique<FeelerBlock>()) {
  for (const Light& light : context.scene.lights) {
    light_places_.push_back(place_of(light));
    has_light_groups_ |= light.group != 0;
    has_two_sided_light_ |= lights_both_sides(light);
    if (light.area && !area_shadow_) area_shadow_ = std::make_unique<AreaShadow>(context.scene, shadow_);
  }
  // A group may have had no lights, but lights of the scene that do not shine on it.
  has_light_groups_ |= std::ranges::any_of(context.scene.parts, [](const Part& part) { return !part.global_lights; });
  block_->feelers_may_gain = !bound_.known();
  block_->irid_wavelength = Vec3(context.scene.settings.irid_wavelength);
  rays_->min_depth.at.fill(kNearestHit);
  rays_->max_depth.at.fill(kFarthestHit);
}

void Stepper::step(std::span<const RayTask> tasks) {
  begin(tasks);
  // Blocks from the queue hold one kind; whatever comes mixed is cut into runs.
  for (std::size_t first = 0; first < tasks.size() && !Interrupt::asked();) {
    const bool shadow = tasks[first].kind == RayKind::shadow;
    const std::size_t most = shadow ? tasks.size() - first : std::min(tasks.size() - first, kRaysAtOnce);
    std::size_t count = 1;
    while (count < most && (tasks[first + count].kind == RayKind::shadow) == shadow) ++count;
    const std::span<const RayTask> run = tasks.subspan(first, count);
    const std::span<Contribution> light = std::span(light_).subspan(first, count);
    if (shadow) {
      step_shadow(run, light);
    } else {
      step_radiance(run, {}, light);
    }
    first += count;
  }
}

void Stepper::step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays) {
  begin(tasks);
  const double sight = std::min(farthest_sight(context_.camera()), kFarthestHit);
  rays_->max_depth.at.fill(sight);
  for (std::size_t first = 0; first < tasks.size() && !Interrupt::asked(); first += kRaysAtOnce) {
    const std::size_t count = std::min(tasks.size() - first, kRaysAtOnce);
    step_radiance(tasks.subspan(first, count), rays.subspan(first, count), std::span(light_).subspan(first, count));
  }
  rays_->max_depth.at.fill(kFarthestHit);
}

void Stepper::begin(std::span<const RayTask> tasks) {
  spawned_.clear();
  clearness_.clear();
  light_.resize(tasks.size());
}

void Stepper::step_radiance(std::span<const RayTask> tasks, std::span<const Ray> rays, std::span<Contribution> light) {
  RayBlock& block = *rays_;
  block.size = tasks.size();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const RayTask& task = tasks[i];
    counts_.of(task.kind)++;
    block.origin.set(i, task.origin);
    packed_directions_[i] = std::bit_cast<std::int64_t>(task.direction());
    block.hidden_bit[i] = hidden_bit(task);
  }
  if (rays.empty()) {
    unpack_directions(packed_directions_, tasks.size(), block.direction);
  } else {
    for (std::size_t i = 0; i < tasks.size(); ++i) block.direction.set(i, rays[i].direction);
  }
  context_.accel.closest(block, hits_);
  // The parts and shapes that were met lie anywhere in memory: ask for all of them before the first is needed.
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (hits_[i].part == kNoIndex) continue;
    __builtin_prefetch(hits_[i].shape);
    __builtin_prefetch(&context_.scene.parts[hits_[i].part]);
  }
  mirrors_.clear();
  coatings_.clear();
  uneven_.clear();
  own_textures_ = 0;
  block_->begin(tasks.size());
  // Matt surfaces first, so that highlights are worked out for few that have none.
  std::size_t matt = 0;
  std::size_t glossy = tasks.size();
  std::array<std::uint8_t, kRaysAtOnce> order;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const RayTask& task = tasks[i];
    light[i] = {task.sample, {}, -bound_.at_stake(task)};
    if (hits_[i].part == kNoIndex) continue;
    order[table_->is_glossy(hits_[i].part) ? --glossy : matt++] = static_cast<std::uint8_t>(i);
  }
  see_surroundings(tasks, light);
  const auto meet_all = [&](std::span<const std::uint8_t> met) {
    find_normals(met);
    std::size_t place = block_->size;
    for (const std::size_t i : met) meet(place++, i, tasks[i], light[i]);
  };
  meet_all(std::span(order).first(matt));
  meet_all(std::span(order).subspan(glossy, tasks.size() - glossy));
  if (own_textures_ != 0) wear_own_textures();
  if (!uneven_.empty()) meet_uneven();
  if (block_->size > 0) shade();
}

void Stepper::step_shadow(std::span<const RayTask> tasks, std::span<Contribution> light) {
  FeelerBlock& block = *feelers_;
  for (std::size_t first = 0; first < tasks.size() && !Interrupt::asked();) {
    // As many records as fit whole.
    block.rays.size = 0;
    std::size_t end = first;
    for (; end < tasks.size() && block.room() >= RayTask::kMostFeelers; ++end) {
      const RayTask& task = tasks[end];
      task.for_each_feeler([&](std::uint32_t to_light, PackedRgb held) { block.add(task.origin, to_light, held); });
    }
    counts_.of(RayKind::shadow) += block.size();
    aim_feelers(block, light_places_);
    const std::uint64_t to_areas = area_shadow_ ? ask_areas(tasks.subspan(first, end - first)) : 0;
    const std::uint64_t shut =
        context_.scene.windows.empty() ? 0 : end_at_windows(tasks.subspan(first, end - first)) & ~to_areas;
    const std::uint64_t blocked = context_.accel.occluded(block.rays) | shut;
    if (shadow_.takes_parts()) ask_passing(tasks.subspan(first, end - first), block.rays.all() & ~(blocked | to_areas));
    weigh_feelers(block);
    std::size_t feeler = 0;
    for (; first < end; ++first) take_back(tasks[first], feeler, blocked, to_areas, light[first]);
  }
}

std::uint64_t Stepper::end_at_windows(std::span<const RayTask> tasks) {
  RayBlock& rays = feelers_->rays;
  std::uint64_t shut = 0;
  std::size_t feeler = 0;
  for (const RayTask& task : tasks) {
    task.for_each_feeler([&](std::uint32_t light, PackedRgb) {
      const std::size_t i = feeler++;
      const Ray ray{task.origin, rays.direction.vector(i)};
      if (!shadow_.end_at_window(context_.scene.lights[light], ray, rays.max_depth[i])) shut |= std::uint64_t{1} << i;
    });
  }
  return shut;
}

std::uint64_t Stepper::ask_areas(std::span<const RayTask> tasks) {
  FeelerBlock& block = *feelers_;
  std::uint64_t to_areas = 0;
  std::vector<AreaShadow::Feeler> asked;
  std::size_t feeler = 0;
  for (const RayTask& task : tasks) {
    task.for_each_feeler([&](std::uint32_t light, PackedRgb) {
      const std::size_t i = feeler++;
      if (!context_.scene.lights[light].area) return;
      to_areas |= std::uint64_t{1} << i;
      asked.push_back({task.origin, light, task.medium});
      block.rays.max_depth[i] = 0.0;  // it is asked here
    });
  }
  std::array<Rgb, kRaysAtOnce> found;
  const std::uint64_t rays = area_shadow_->find(asked, std::span(found).first(asked.size()));
  counts_.of(RayKind::shadow) += rays;
  counts_.of(RayKind::shadow) -= asked.size();
  std::size_t k = 0;
  for (std::uint64_t bits = to_areas; bits != 0; bits &= bits - 1) {
    shares_[static_cast<std::size_t>(std::countr_zero(bits))] = found[k++];
  }
  return to_areas;
}

void Stepper::ask_passing(std::span<const RayTask> tasks, std::uint64_t open) {
  std::array<std::uint32_t, kRaysAtOnce> media;
  std::array<std::uint32_t, kRaysAtOnce> lights;
  std::size_t feeler = 0;
  for (const RayTask& task : tasks) {
    task.for_each_feeler([&](std::uint32_t light, PackedRgb) {
      media[feeler] = task.medium;
      lights[feeler++] = light;
    });
  }
  shadow_.pass_surfaces(feelers_->rays, open, std::span(media).first(feeler), std::span(lights).first(feeler), shares_);
}

void Stepper::take_back(const RayTask& task, std::size_t& feeler, std::uint64_t blocked, std::uint64_t to_areas,
                        Contribution& light) {
  FixedRgb taken;
  FixedRgb at_stake;
  const std::size_t end = feeler + static_cast<std::size_t>(task.ray_count());
  const std::int64_t count = task.ray_count();
  for (; feeler < end; ++feeler) {
    const auto& steps = feelers_->steps.of;
    const FixedRgb held{steps[0][feeler], steps[1][feeler], steps[2][feeler]};
    at_stake += {std::abs(held.r), std::abs(held.g), std::abs(held.b)};
    Rgb passed(1.0f);
    if ((blocked >> feeler & 1u) != 0) {
      passed = Rgb(0.0f);
    } else if ((to_areas >> feeler & 1u) != 0 || shadow_.takes_parts()) {
      passed = shares_[feeler];
    }
    if (passed == Rgb(1.0f)) continue;
    if (passed == Rgb(0.0f)) {
      taken -= held;
    } else {
      taken += FixedRgb::from(PackedRgb::from_bits(feelers_->at_stake[feeler]).unpack() * (passed - Rgb(1.0f)));
    }
  }
  light = {task.sample, taken, -(count + bound_.most_of_feelers(at_stake.max_magnitude()))};
}

void Stepper::add_sealed(const Surface& surface, RayTask root, double exponent) {
  const Rgb weight = root.weight();
  root.set_weight(Rgb(1.0f), root.adc_weight());
  const Rgb color = trace_sealed(root);
  // Negative light has a square, and no square root. What is negative by the rounding of what feelers hold alone is
  // none.
  constexpr float kRounding = 0x1p-14f;
  const auto power = [exponent](float c) {
    const auto raised = static_cast<float>(steady::power(c < 0.0f && c > -kRounding ? 0.0f : c, exponent));
    return std::isnan(raised) ? -static_cast<float>(kDarkness) : raised;
  };
  surface.sum->light += FixedRgb::from(weight * Rgb(power(color.x), power(color.y), power(color.z)));
}

Rgb Stepper::trace_sealed(const RayTask& root) {
  if (!sealed_) sealed_ = std::make_unique<Stepper>(context_, table_);
  const RayCounts before = sealed_->counts_;
  FixedRgb sum;
  std::vector<RayTask> waiting{root};
  while (!waiting.empty() && !Interrupt::asked()) {
    const RayTask task = waiting.back();
    waiting.pop_back();
    sealed_->step({&task, 1});
    for (const Contribution& contribution : sealed_->light()) sum += contribution.light;
    waiting.insert(waiting.end(), sealed_->spawned().begin(), sealed_->spawned().end());
  }
  counts_ += sealed_->counts_ - before;
  return sum.to_rgb();
}

}  // namespace firstlight::render
