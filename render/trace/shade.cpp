// The surface a ray meets: its own light, lights as if unoccluded, and the rays it sends on.

#include "render/trace/fade.h"
#include "render/trace/local_light.h"
#include "render/trace/step.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kNegligible = 1e-10;

bool gives_diffuse_or_highlights(const Finish& finish) {
  return finish.diffuse != 0.0 || finish.diffuse_back != 0.0 || finish.specular != 0.0 || finish.phong != 0.0;
}

bool is_negligible(const Rgb& light) { return max_magnitude(light) < static_cast<float>(kNegligible); }

std::uint32_t mixed(std::uint32_t path, std::uint32_t branch) {
  std::uint32_t h = path * 0x9e3779b1u + branch + 1u;
  h ^= h >> 15;
  h *= 0x85ebca77u;
  return h ^ (h >> 13);
}

}  // namespace

void Stepper::shade(const RayTask& task, const Ray& ray, const Hit& hit) {
  const Scene& scene = context_.scene;
  const Part& part = scene.parts[hit.part];
  const Vec3 point = ray.at(hit.depth);
  Vec3 normal = hit.shape->normal(point, {hit.depth, hit.shape, hit.part, hit.face});
  const bool from_inside = normal.dot(ray.direction) > 0.0;
  if (from_inside) normal = -normal;
  const bool continued = (task.flags & RayTask::kContinued) != 0;
  const Surface surface{.task = task,
                        .part = part,
                        .interior = scene.interiors[part.interior],
                        .direction = ray.direction,
                        .point = point,
                        .normal = normal,
                        .depth = hit.depth,
                        .level = task.level + (continued ? 0 : 1)};

  const std::uint32_t texture = from_inside && part.interior_texture != kNoIndex ? part.interior_texture : part.texture;
  if (texture == kNoIndex) return;

  const Rgb filter = shade_layers(surface, scene.textures[texture]);
  shade_lights(surface);
  const double share = std::min(1.0, static_cast<double>(std::abs(grey(filter))));
  bool totally_reflected = false;
  if (share > scene.settings.adc_bailout) totally_reflected = spawn_transmission(surface, filter);
  if (!totally_reflected) spawn_reflections(surface);
}

Rgb Stepper::shade_layers(const Surface& surface, const PlacedTexture& texture) {
  const Settings& settings = context_.scene.settings;
  const Vec3 local = texture.to_texture.is_identity() ? surface.point : texture.to_texture.point(surface.point);
  layers_.clear();
  Rgb filter(1.0f);
  double share = 1.0;
  Rgb own_light(0.0f);
  for (const TextureLayer& layer : texture.texture->layers) {
    if (share <= settings.adc_bailout) break;
    const FilteredColor pigment = color_at(layer.pigment, local);
    const Finish& finish = layer.finish;
    // Before 3.7 a tinted layer kept more of its own light. [POV-Ray 3.7: language version below 370]
    const double opacity = settings.language_version < 370
                               ? 1.0 - (pigment.filter * max_component(pigment.rgb) + pigment.transmit)
                               : 1.0 - pigment.filter - pigment.transmit;
    Layer& shaded = layers_.emplace_back(Layer{.finish = &finish,
                                               .color = pigment.rgb,
                                               .filter = filter,
                                               .opacity = opacity,
                                               .adc_weight = surface.task.radiance.adc_weight * share,
                                               .reflection = Rgb(0.0f)});
    shaded.reflection = reflectivity(surface, finish, pigment.rgb, shaded.adc_weight);
    own_light += filter * pigment.rgb * (finish.ambient * settings.ambient_light + finish.emission) *
                 static_cast<float>(opacity);
    filter *= pigment.passed();
    if (finish.conserve_energy) {
      const Rgb kept = Rgb(1.0f) - shaded.reflection;
      filter *= Rgb(std::min(1.0f, kept.x), std::min(1.0f, kept.y), std::min(1.0f, kept.z));
    }
    share = std::min(1.0, static_cast<double>(std::abs(grey(filter))));
  }
  add_light(surface.task.radiance.weight() * own_light);
  return filter;
}

void Stepper::shade_lights(const Surface& surface) {
  if (std::none_of(layers_.begin(), layers_.end(),
                   [](const Layer& layer) { return gives_diffuse_or_highlights(*layer.finish); })) {
    return;
  }
  const std::vector<Light>& lights = context_.scene.lights;
  // All square roots first: behind the branches below the processor would wait for each of them.
  arriving_.resize(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) arriving_[i] = illuminate(lights[i], surface.point);
  const std::size_t first_feeler = spawned_.size();
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const Illumination& light = arriving_[i];
    if (is_negligible(light.color)) continue;
    const bool behind = !surface.part.double_illuminate && surface.normal.dot(light.direction) < kNegligible;
    Rgb lit(0.0f);
    for (const Layer& layer : layers_) {
      const Finish& finish = *layer.finish;
      if (behind && finish.diffuse_back == 0.0) continue;
      Rgb term = diffuse_light(finish, behind ? finish.diffuse_back : finish.diffuse, surface.normal, light,
                               layer.color, layer.opacity);
      if (!behind && !lights[i].shadowless) {
        if (finish.phong > 0.0) term += phong_light(finish, surface.direction, surface.normal, light, layer.color);
        if (finish.specular > 0.0)
          term += specular_light(finish, surface.direction, surface.normal, light, layer.color);
      }
      lit += layer.filter * term;
    }
    const Rgb weighted = surface.task.radiance.weight() * lit;
    if (is_black(weighted)) continue;
    if (lights[i].shadowless) {
      add_light(weighted);
      continue;
    }
    // What is added is what the feeler can keep, so that a blocked light leaves nothing behind.
    const PackedRgb at_stake(weighted);
    sum_ += FixedRgb::from(at_stake);
    if (spawned_.size() > first_feeler && spawned_.back().add_feeler(i, at_stake)) continue;
    spawned_.push_back(child_of(surface, RayKind::shadow));
    spawned_.back().set_feeler(i, at_stake);
  }
  for (std::size_t i = first_feeler; i < spawned_.size(); ++i) spawned_at_stake_ += bound_.at_stake(spawned_[i]);
}

RayTask Stepper::child_of(const Surface& surface, RayKind kind) const {
  RayTask child;
  child.origin = surface.point;
  child.sample = surface.task.sample;
  child.medium = surface.task.medium;
  child.kind = kind;
  child.level = static_cast<std::uint8_t>(std::min(surface.level, 255));
  child.flags = surface.task.flags & RayTask::kReflected;
  child.object = static_cast<std::uint16_t>(std::min<std::uint32_t>(surface.part.object, RayTask::kNoObject));
  return child;
}

Rgb Stepper::reflectivity(const Surface& surface, const Finish& finish, const Rgb& color, double& adc_weight) const {
  const float strongest = std::max(max_component(finish.reflection_max), max_component(finish.reflection_min));
  if (is_black(finish.reflection_max) && is_black(finish.reflection_min)) {
    adc_weight *= strongest;
    return Rgb(0.0f);
  }
  const double cosine = -surface.direction.dot(surface.normal);
  Rgb reflected;
  if (finish.reflection_fresnel) {
    // Unpolarised light: 1/2 ((g-c)/(g+c))^2 (1 + ((c(g+c)-1)/(c(g-c)+1))^2), g^2 = n^2 + c^2 - 1.
    const double ior = relative_ior(surface);
    const double g2 = ior * ior + cosine * cosine - 1.0;
    if (g2 > 0.0) {
      const double g = std::sqrt(g2);
      const double ratio = (g - cosine) / (g + cosine);
      const double polarised = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
      const float f = static_cast<float>(std::clamp(0.5 * ratio * ratio * (1.0 + polarised * polarised), 0.0, 1.0));
      reflected = finish.reflection_max * f + finish.reflection_min * (1.0f - f);
    } else {
      reflected = finish.reflection_max;
    }
    adc_weight *= max_component(reflected);
  } else {
    adc_weight *= strongest;
    const double grazing = 1.0 - cosine;
    const double fraction = std::abs(finish.reflection_falloff - 1.0) > kNegligible
                                ? std::pow(grazing, finish.reflection_falloff)
                                : grazing;
    reflected = finish.reflection_max * static_cast<float>(fraction) +
                finish.reflection_min * static_cast<float>(1.0 - fraction);
  }
  if (finish.reflection_metallic != 0.0) {
    reflected = metallic_tint(reflected, color, finish.reflection_metallic, cosine);
  }
  return reflected;
}

double Stepper::relative_ior(const Surface& surface) const {
  const Scene& scene = context_.scene;
  const MediumTable& media = context_.media;
  const std::uint32_t medium = surface.task.medium;
  const double ior = surface.interior.ior;
  if (medium == MediumTable::kOutside) return ior / scene.settings.atmosphere_ior;
  const double around = scene.interiors[media.innermost(medium)].ior;
  if (!media.contains(medium, surface.part.interior)) return ior / around;
  return (media.depth(medium) == 1 ? scene.settings.atmosphere_ior : around) / ior;
}

void Stepper::spawn_reflections(const Surface& surface) {
  for (std::uint32_t i = 0; i < layers_.size(); ++i) {
    const Layer& layer = layers_[i];
    if (is_black(layer.reflection)) continue;
    RayTask child = child_of(surface, RayKind::reflection);
    const Vec3 mirrored = surface.direction - surface.normal * (2.0 * surface.direction.dot(surface.normal));
    child.radiance.direction = PackedDirection(mirrored);
    child.radiance.set_weight(surface.task.radiance.weight() * layer.reflection);
    child.radiance.adc_weight = static_cast<float>(layer.adc_weight);
    child.flags |= RayTask::kReflected;
    child.path = mixed(surface.task.path, 0x10000u + i);
    if (surface.level >= context_.scene.settings.max_trace_level || !is_worth_tracing(context_.scene.settings, child)) {
      continue;
    }
    if (layer.finish->reflection_exponent != 1.0) {
      add_sealed(child, child.radiance.weight(), layer.finish->reflection_exponent);
    } else {
      spawn(child);
    }
  }
}

bool Stepper::spawn_transmission(const Surface& surface, const Rgb& filter) {
  const Scene& scene = context_.scene;
  MediumTable& media = context_.media;
  const std::uint32_t own = surface.part.interior;
  const std::uint32_t around = surface.task.medium;

  // Nested matter counts as outside of what surrounds it; of overlapping matter, the one met last fills the overlap.
  RayTask child = child_of(surface, RayKind::transmission);
  double ior = 1.0;  // of the side the ray comes from, relative to the side it goes to
  if (around == MediumTable::kOutside) {
    child.medium = media.entered(around, own);
    ior = scene.settings.atmosphere_ior / surface.interior.ior;
  } else if (media.innermost(around) == own) {
    child.medium = media.left(around, own);
    const double beyond = child.medium == MediumTable::kOutside ? scene.settings.atmosphere_ior
                                                                : scene.interiors[media.innermost(child.medium)].ior;
    ior = surface.interior.ior / beyond;
  } else if (media.contains(around, own)) {
    child.medium = media.left(around, own);
  } else {
    ior = scene.interiors[media.innermost(around)].ior / surface.interior.ior;
    child.medium = media.entered(around, own);
  }

  Rgb passed = Rgb(static_cast<float>(surface.interior.refraction_scale));
  if (std::abs(surface.interior.fade_distance) > kNegligible && media.contains(around, own)) {
    passed *= faded_light(surface.interior, surface.depth);
  }
  child.radiance.adc_weight = surface.task.radiance.adc_weight * max_magnitude(filter);
  child.path = mixed(surface.task.path, 0x20000u);

  bool totally_reflected = false;
  if (std::abs(ior - 1.0) < kNegligible) {
    child.radiance.direction = PackedDirection(surface.direction);
    child.flags |= RayTask::kContinued;
  } else {
    // Heckbert's form of Snell's law: T = ior I + (ior c - sqrt(1 + ior^2 (c^2 - 1))) N.
    const double cosine = -surface.direction.dot(surface.normal);
    const double root = 1.0 + ior * ior * (cosine * cosine - 1.0);
    totally_reflected = root < 0.0;
    if (totally_reflected) {
      child.kind = RayKind::reflection;
      child.flags |= RayTask::kReflected;
      child.medium = around;
      child.radiance.direction = PackedDirection(surface.direction + surface.normal * (2.0 * cosine));
    } else {
      child.radiance.direction =
          PackedDirection(surface.direction * ior + surface.normal * (ior * cosine - std::sqrt(root)));
    }
  }
  child.radiance.set_weight(surface.task.radiance.weight() * passed * (totally_reflected ? Rgb(1.0f) : filter));
  if (surface.level < scene.settings.max_trace_level && is_worth_tracing(scene.settings, child)) spawn(child);
  return totally_reflected;
}

}  // namespace firstlight::render
