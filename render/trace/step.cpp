#include "render/trace/step.h"

#include "render/trace/fade.h"

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
  return *this;
}

bool is_worth_tracing(const Settings& settings, const RayTask& task) {
  return task.level < settings.max_trace_level && !(task.radiance.adc_weight < settings.adc_bailout);
}

Stepper::Stepper(const TraceContext& context, std::shared_ptr<const SurfaceTable> surfaces)
    : context_(context),
      table_(std::move(surfaces)),
      bound_(context.scene),
      has_transparent_casters_(std::any_of(context.scene.parts.begin(), context.scene.parts.end(),
                                           [](const Part& part) { return !part.opaque; })),
      rays_(std::make_unique<RayBlock>()),
      block_(std::make_unique<HitBlock>()),
      feelers_(std::make_unique<FeelerBlock>()) {
  for (const Light& light : context.scene.lights) {
    light_places_.push_back({light.position.x, light.position.y, light.position.z, 0.0});
  }
  rays_->min_depth.at.fill(kNearestHit);
  rays_->max_depth.at.fill(kFarthestHit);
}

void Stepper::step(std::span<const RayTask> tasks) {
  begin(tasks);
  // Blocks from the queue hold one kind; whatever comes mixed is cut into runs.
  for (std::size_t first = 0; first < tasks.size();) {
    const bool shadow = tasks[first].kind == RayKind::shadow;
    const std::size_t most = std::min(tasks.size() - first, kRaysAtOnce);
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
  for (std::size_t first = 0; first < tasks.size(); first += kRaysAtOnce) {
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
    packed_directions_[i] = std::bit_cast<std::int64_t>(task.radiance.direction);
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
  surfaces_.clear();
  mirrors_.clear();
  block_->begin(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const RayTask& task = tasks[i];
    light[i] = {task.sample, {}, -bound_.at_stake(task)};
    if (hits_[i].part == kNoIndex) {
      light[i].light = FixedRgb::from(task.radiance.weight() * context_.scene.settings.background);
    } else {
      meet(task, {task.origin, block.direction.vector(i)}, hits_[i], light[i]);
    }
  }
  if (!surfaces_.empty()) shade();
}

void Stepper::step_shadow(std::span<const RayTask> tasks, std::span<Contribution> light) {
  FeelerBlock& block = *feelers_;
  block.begin(tasks.size());
  std::size_t feelers = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const RayTask& task = tasks[i];
    block.origin.set(i, task.origin);
    std::size_t slot = 0;
    task.for_each_feeler([&](std::uint32_t which, PackedRgb at_stake) { block.add(i, slot++, which, at_stake); });
    feelers += slot;
  }
  counts_.of(RayKind::shadow) += feelers;
  aim_feelers(block, light_places_);
  for (std::size_t s = 0; s < block.slot_count; ++s) {
    FeelerBlock::Slot& slot = block.slots[s];
    slot.blocked = context_.accel.occluded(slot.rays);
  }
  take_back(block);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    light[i] = {tasks[i].sample, {block.sum.of[0][i], block.sum.of[1][i], block.sum.of[2][i]}, -block.at_stake[i]};
  }
  if (has_transparent_casters_) let_through(tasks, light);
}

void Stepper::let_through(std::span<const RayTask> tasks, std::span<Contribution> light) {
  for (std::size_t s = 0; s < feelers_->slot_count; ++s) {
    const FeelerBlock::Slot& slot = feelers_->slots[s];
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (slot.at_stake[i] == 0 || (slot.blocked >> i & 1u) != 0) continue;
      const Ray feeler{tasks[i].origin, slot.rays.direction.vector(i)};
      const Rgb passed = passing_light(tasks[i].medium, feeler, slot.rays.max_depth[i] + kShadowGap);
      if (passed == Rgb(1.0f)) continue;
      const Rgb at_stake = PackedRgb::from_bits(slot.at_stake[i]).unpack();
      light[i].light += FixedRgb::from(at_stake * (passed - Rgb(1.0f)));
    }
  }
}

Rgb Stepper::passing_light(std::uint32_t medium, Ray ray, double distance) const {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  Rgb passed(1.0f);
  while (distance > 2.0 * kShadowGap && !is_black(passed)) {
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
      const PlacedTexture& placed = scene.textures[texture];
      const Vec3 local = placed.to_texture.point(point);
      for (const TextureLayer& layer : placed.texture->layers) passed *= color_at(layer.pigment, local).passed();
      const Interior& interior = scene.interiors[part.interior];
      if (interior.fade_power > 0.0 && std::abs(interior.fade_distance) > kNegligible &&
          media.contains(medium, part.interior)) {
        passed *= faded_light(interior, hit.depth);
      }
    }
    medium = media.contains(medium, part.interior) ? media.left(medium, part.interior)
                                                   : media.entered(medium, part.interior);
    distance -= hit.depth;
    ray.origin = point;
  }
  return passed;
}

void Stepper::add_sealed(const Surface& surface, RayTask root, double exponent) {
  const Rgb weight = root.radiance.weight();
  root.radiance.set_weight(Rgb(1.0f));
  const Rgb color = trace_sealed(root);
  const auto power = [exponent](float c) { return c > 0.0f ? static_cast<float>(std::pow(c, exponent)) : 0.0f; };
  surface.sum->light += FixedRgb::from(weight * Rgb(power(color.x), power(color.y), power(color.z)));
}

Rgb Stepper::trace_sealed(const RayTask& root) {
  if (!sealed_) sealed_ = std::make_unique<Stepper>(context_, table_);
  const RayCounts before = sealed_->counts_;
  FixedRgb sum;
  std::vector<RayTask> waiting{root};
  while (!waiting.empty()) {
    const RayTask task = waiting.back();
    waiting.pop_back();
    sealed_->step({&task, 1});
    for (const Contribution& contribution : sealed_->light()) sum += contribution.light;
    waiting.insert(waiting.end(), sealed_->spawned().begin(), sealed_->spawned().end());
  }
  for (std::size_t i = 0; i < counts_.by_kind.size(); ++i) {
    counts_.by_kind[i] += sealed_->counts_.by_kind[i] - before.by_kind[i];
  }
  return sum.to_rgb();
}

}  // namespace firstlight::render
