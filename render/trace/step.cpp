#include "render/trace/step.h"

#include "render/trace/fade.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

// POV-Ray 3.7's distances, in scene units: a radiance ray leaves its origin's surface behind at kNearestHit; a
// feeler ignores what is closer than kShadowGap to either of its ends.
constexpr double kNearestHit = 1e-4;
constexpr double kShadowGap = 1e-3;
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

Stepper::Stepper(const TraceContext& context)
    : context_(context),
      bound_(context.scene),
      has_transparent_casters_(std::any_of(context.scene.parts.begin(), context.scene.parts.end(),
                                           [](const Part& part) { return !part.opaque; })) {}

void Stepper::step(std::span<const RayTask> tasks) {
  light_.clear();
  spawned_.clear();
  // Blocks from the queue hold one kind; whatever comes mixed is cut into runs.
  for (std::size_t begin = 0; begin < tasks.size();) {
    const bool shadow = tasks[begin].kind == RayKind::shadow;
    std::size_t end = begin + 1;
    while (end < tasks.size() && (tasks[end].kind == RayKind::shadow) == shadow) ++end;
    if (shadow) {
      step_shadow(tasks.subspan(begin, end - begin));
    } else {
      step_radiance(tasks.subspan(begin, end - begin), {});
    }
    begin = end;
  }
}

void Stepper::step_primary(std::span<const RayTask> tasks, std::span<const Ray> rays) {
  light_.clear();
  spawned_.clear();
  step_radiance(tasks, rays);
}

void Stepper::step_radiance(std::span<const RayTask> tasks, std::span<const Ray> rays) {
  queries_.resize(tasks.size());
  hits_.resize(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    counts_.of(tasks[i].kind)++;
    const Ray ray = rays.empty() ? Ray{tasks[i].origin, tasks[i].radiance.direction.unpack()} : rays[i];
    queries_[i] = {ray, kNearestHit, kFarthestHit, hidden_bit(tasks[i])};
  }
  context_.accel.closest(queries_, hits_);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (hits_[i].part == kNoIndex) {
      add_light(tasks[i].radiance.weight() * context_.scene.settings.background);
    } else {
      shade(tasks[i], queries_[i].ray, hits_[i]);
    }
    finish(tasks[i]);
  }
}

void Stepper::step_shadow(std::span<const RayTask> tasks) {
  queries_.clear();
  for (const RayTask& task : tasks) {
    task.for_each_feeler([&](std::uint32_t light, const PackedRgb&) {
      const Illumination lit = illuminate(context_.scene.lights[light], task.origin);
      queries_.push_back({{task.origin, lit.direction}, kShadowGap, lit.distance - kShadowGap, kHiddenFromShadow});
    });
  }
  counts_.of(RayKind::shadow) += queries_.size();
  blocked_.resize(queries_.size());
  context_.accel.occluded(queries_, blocked_);
  std::size_t i = 0;
  for (const RayTask& task : tasks) {
    task.for_each_feeler([&](std::uint32_t, const PackedRgb& at_stake) {
      const RayQuery& query = queries_[i];
      if (blocked_[i++] != 0) {
        sum_ -= FixedRgb::from(at_stake);
      } else if (has_transparent_casters_) {
        const Rgb passed = passing_light(task.medium, query.ray, query.max_depth + kShadowGap);
        if (passed != Rgb(1.0f)) add_light(at_stake.unpack() * (passed - Rgb(1.0f)));
      }
    });
    finish(task);
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

void Stepper::finish(const RayTask& task) {
  light_.push_back({task.sample, sum_, spawned_at_stake_ - bound_.at_stake(task)});
  sum_ = FixedRgb();
  spawned_at_stake_ = 0;
}

void Stepper::spawn(const RayTask& task) {
  if (is_black(task.radiance.weight())) return;
  spawned_.push_back(task);
  spawned_at_stake_ += bound_.at_stake(task);
}

void Stepper::add_sealed(RayTask root, const Rgb& weight, double exponent) {
  root.radiance.set_weight(Rgb(1.0f));
  const Rgb color = trace_sealed(root);
  const auto power = [exponent](float c) { return c > 0.0f ? static_cast<float>(std::pow(c, exponent)) : 0.0f; };
  add_light(weight * Rgb(power(color.x), power(color.y), power(color.z)));
}

Rgb Stepper::trace_sealed(const RayTask& root) {
  if (!sealed_) sealed_ = std::make_unique<Stepper>(context_);
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
