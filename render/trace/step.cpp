#include "render/trace/step.h"

#include "render/math/interrupt.h"
#include "render/trace/fade.h"
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
  return (task.flags & RayTask::kReflected) != 0 ? kHiddenFromReflection : kHiddenFromPrimary;
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

bool is_worth_tracing(const Settings& settings, const RayTask& task) {
  return task.level < settings.max_trace_level && !(task.adc_weight() < settings.adc_bailout);
}

Stepper::Stepper(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces)
    : context_(context),
      table_(std::move(surfaces)),
      veils_of_scene_(context.scene),
      bound_(context.scene),
      has_transparent_casters_(std::any_of(context.scene.parts.begin(), context.scene.parts.end(),
                                           [](const Part& part) { return !part.opaque; })),
      rays_(std::make_unique<RayBlock>()),
      block_(std::make_unique<HitBlock>()),
      feelers_(std::make_unique<FeelerBlock>()),
      asked_(std::make_unique<SurfacePoints>()) {
  for (const Light& light : context.scene.lights) {
    light_places_.push_back({light.position.x, light.position.y, light.position.z, 0.0});
  }
  has_transparent_casters_ = has_transparent_casters_ || std::ranges::any_of(context.scene.lights, [this](const Light& light) {
    return veils_of_scene_.weaken(light);
  });
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
  for (std::size_t first = 0; first < tasks.size() && !Interrupt::asked(); first += kRaysAtOnce) {
    const std::size_t count = std::min(tasks.size() - first, kRaysAtOnce);
    step_radiance(tasks.subspan(first, count), rays.subspan(first, count), std::span(light_).subspan(first, count));
  }
}

void Stepper::begin(std::span<const RayTask> tasks) {
  spawned_.clear();
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
  // What was met lies anywhere in memory: ask for all of it before the first is needed.
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (hits_[i].part == kNoIndex) continue;
    __builtin_prefetch(hits_[i].shape);
    __builtin_prefetch(&context_.scene.parts[hits_[i].part]);
  }
  mirrors_.clear();
  coatings_.clear();
  uneven_.clear();
  block_->begin(tasks.size());
  // Matt surfaces first, so that highlights are worked out for few that have none.
  std::size_t matt = 0;
  std::size_t glossy = tasks.size();
  std::array<std::uint8_t, kRaysAtOnce> order;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const RayTask& task = tasks[i];
    light[i] = {task.sample, {}, -bound_.at_stake(task)};
    if (hits_[i].part == kNoIndex) continue;
    const std::uint32_t texture = context_.scene.parts[hits_[i].part].texture;
    const bool is_glossy = texture != kNoIndex && table_->is_glossy(texture);
    order[is_glossy ? --glossy : matt++] = static_cast<std::uint8_t>(i);
  }
  see_surroundings(tasks, light);
  const bool is_veiled = !veils_of_scene_.empty();
  const auto meet_all = [&](std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) {
      const std::size_t i = order[k];
      const Rgb weight = is_veiled ? tasks[i].weight() * veils_[i].kept : tasks[i].weight();
      meet(tasks[i], {tasks[i].origin, block.direction.vector(i)}, hits_[i], weight, light[i]);
    }
  };
  meet_all(0, matt);
  meet_all(glossy, tasks.size());
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
    const std::uint64_t blocked = context_.accel.occluded(block.rays);
    weigh_feelers(block);
    std::size_t feeler = 0;
    for (; first < end; ++first) take_back(tasks[first], feeler, blocked, light[first]);
  }
}

void Stepper::take_back(const RayTask& task, std::size_t& feeler, std::uint64_t blocked, Contribution& light) const {
  FixedRgb taken;
  FixedRgb at_stake;
  const std::size_t end = feeler + static_cast<std::size_t>(task.ray_count());
  const std::int64_t count = task.ray_count();
  for (; feeler < end; ++feeler) {
    const auto& steps = feelers_->steps.of;
    const FixedRgb held{steps[0][feeler], steps[1][feeler], steps[2][feeler]};
    at_stake += {std::abs(held.r), std::abs(held.g), std::abs(held.b)};
    if ((blocked >> feeler & 1u) != 0) {
      taken -= held;
    } else if (has_transparent_casters_) {
      taken += lost_light(task, feeler);
    }
  }
  light = {task.sample, taken, -(count + bound_.most_of_feelers(at_stake.max_magnitude()))};
}

FixedRgb Stepper::lost_light(const RayTask& task, std::size_t feeler) const {
  const RayBlock& rays = feelers_->rays;
  const Ray ray{task.origin, rays.direction.vector(feeler)};
  const Light& light = context_.scene.lights[static_cast<std::size_t>(feelers_->light[feeler])];
  const Rgb passed =
      passing_light(task.medium, ray, rays.max_depth[feeler] + kShadowGap, veils_of_scene_.weaken(light));
  if (passed == Rgb(1.0f)) return {};
  return FixedRgb::from(PackedRgb::from_bits(feelers_->at_stake[feeler]).unpack() * (passed - Rgb(1.0f)));
}

Rgb Stepper::passing_light(std::uint32_t medium, Ray ray, double distance, bool through_fog) const {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  Rgb passed(1.0f);
  const auto pass_fog = [&](double depth) {
    if (through_fog && is_hollow(scene, media, medium)) passed *= veils_of_scene_.left_of_light(ray, depth);
  };
  while (distance > 2.0 * kShadowGap && !is_black(passed) && !Interrupt::asked()) {
    const RayQuery query{ray, kShadowGap, distance - kShadowGap, kHiddenFromShadow};
    Hit hit;
    context_.accel.closest({&query, 1}, {&hit, 1});
    if (hit.part == kNoIndex) break;
    const Part& part = scene.parts[hit.part];
    if (part.opaque) return Rgb(0.0f);  // was nearer than the gap to the origin before the ray moved on
    const Vec3 point = ray.at(hit.depth);
    std::uint32_t texture = part.texture;
    if (part.interior_texture != kNoIndex) {
      const Vec3 normal = hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face});
      if (normal.dot(ray.direction) > 0.0) texture = part.interior_texture;
    }
    if (texture != kNoIndex) {
      asked_->size = 1;
      asked_->at.set(0, point);
      asked_->direction.set(0, ray.direction);
      const Interior& interior = scene.interiors[part.interior];
      asked_->on_surface = interior.caustics != 0.0;
      if (asked_->on_surface) {
        const Vec3 normal = hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face});
        asked_->normal.set(0, normal.dot(ray.direction) > 0.0 ? -normal : normal);
        asked_->tilted.set(0, asked_->normal.vector(0));
        asked_->place.set(0, point);
        asked_->u[0] = asked_->v[0] = 0.0;
      }
      table_->filter(texture, *asked_, {&passed, 1}, interior.caustics);
      if (interior.fade_power > 0.0 && std::abs(interior.fade_distance) > kNegligible &&
          media.contains(medium, part.interior)) {
        passed *= faded_light(interior, hit.depth);
      }
    }
    pass_fog(hit.depth);
    medium = media.contains(medium, part.interior) ? media.left(medium, part.interior)
                                                   : media.entered(medium, part.interior);
    distance -= hit.depth;
    ray.origin = point;
  }
  pass_fog(distance);
  return passed;
}

void Stepper::add_sealed(const Surface& surface, RayTask root, double exponent) {
  const Rgb weight = root.weight();
  root.set_weight(Rgb(1.0f), root.adc_weight());
  const Rgb color = trace_sealed(root);
  // Negative light has a square, and no square root. What is negative by the rounding of what feelers hold alone is none.
  constexpr float kRounding = 0x1p-14f;
  const auto power = [exponent](float c) {
    const auto raised = static_cast<float>(std::pow(c < 0.0f && c > -kRounding ? 0.0f : c, exponent));
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
