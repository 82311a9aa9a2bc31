#include "tests/render/random_scene.h"

#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"
#include "render/texture/patterning.h"
#include "render/trace/primary.h"

#include <random>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

class Maker {
 public:
  Maker(std::uint32_t seed, Fancy fancy) : random_(seed), fancy_(fancy) {}

  std::unique_ptr<const Scene> make();

 private:
  bool wild() const { return fancy_ == Fancy::wild; }
  bool chance(double probability) { return between(0.0, 1.0) < probability; }
  int choice(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  float number(double low, double high) { return static_cast<float>(between(low, high)); }
  /// From 0 to `most`; of wild scenes sometimes beyond, to both sides.
  double amount(double most) { return wild() && chance(0.05) ? between(-most, 2.0 * most) : between(0.0, most); }
  /// Not negative, unless the scene is wild.
  double power(double most) { return wild() && chance(0.03) ? between(-2.0, 0.0) : between(0.0, most); }
  Rgb color(double most) {
    return {static_cast<float>(amount(most)), static_cast<float>(amount(most)), static_cast<float>(amount(most))};
  }
  Vec3 point(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

  FilteredColor filtered(bool clear);
  Pigment pigment();
  Finish finish();
  TexturePtr texture();
  Interior interior();
  Object object();
  Object light();

  std::mt19937 random_;
  Fancy fancy_;
};

FilteredColor Maker::filtered(bool clear) {
  FilteredColor result{color(1.0)};
  if (!clear) return result;
  if (chance(fancy_ == Fancy::clear_rows ? 0.5 : 0.1)) return {Rgb(1.0f), 0.0f, 1.0f};
  result.filter = number(0.0, 0.95);
  result.transmit = number(0.0, 0.95 - static_cast<double>(result.filter));
  if (wild() && chance(0.2)) result.transmit += number(-0.5, 0.5);
  return result;
}

Pigment Maker::pigment() {
  Pigment result;
  const bool clear = chance(0.6);
  result.color = filtered(clear);
  if (chance(0.4)) return result;
  PigmentPattern pattern{chance(0.3) ? patterned(PatternKind::checker)
                                     : patterned(PatternKind::gradient, GradientParameters{point(1.0)})};
  const int entries = 2 + choice(3);
  for (int i = 0; i < entries; ++i) pattern.map.push_back({i / 3.0, filtered(clear && chance(0.8))});
  pattern.wave.form = chance(0.5) ? WaveForm::ramp : WaveForm::sine;
  pattern.warps.transform(Transform::scaling(Vec3(between(0.2, 1.0))));
  result.pattern = std::move(pattern);
  return result;
}

Finish Maker::finish() {
  Finish result;
  result.ambient = color(0.3);
  if (chance(0.2)) result.emission = color(0.5);
  result.diffuse = amount(0.9);
  if (chance(0.2)) result.diffuse_back = amount(0.5);
  if (chance(0.3)) result.brilliance = power(3.0);
  if (chance(0.4)) result.phong = amount(1.0);
  if (chance(0.4)) result.specular = amount(1.0);
  result.phong_size = power(80.0);
  result.roughness_exponent = power(200.0);
  if (chance(0.3)) result.metallic = amount(1.0);
  if (chance(0.6)) {
    result.reflection_max = color(0.8);
    result.reflection_min = chance(0.5) ? result.reflection_max : color(0.5);
    if (chance(0.3)) result.reflection_falloff = power(3.0);
    if (chance(0.3)) result.reflection_metallic = amount(1.0);
    if (chance(0.2)) result.reflection_exponent = 0.3 + power(2.0);
    result.reflection_fresnel = chance(0.3);
  }
  result.conserve_energy = chance(0.3);
  return result;
}

TexturePtr Maker::texture() {
  Texture result;
  const int layers = chance(0.6) ? 1 : 2 + choice(2);
  for (int i = 0; i < layers; ++i) result.layers.push_back({pigment(), finish()});
  return std::make_shared<const Texture>(std::move(result));
}

Interior Maker::interior() {
  Interior result;
  if (fancy_ != Fancy::clear_rows && chance(0.7)) result.ior = chance(0.5) ? 1.5 : between(0.7, 2.0);
  if (chance(0.4)) {
    result.fade_distance = wild() && chance(0.1) ? -1.0 : between(0.2, 3.0);
    result.fade_power = chance(0.3) ? 1001.0 : power(3.0);
    result.fade_color = color(1.0);
  }
  if (chance(0.2)) result.refraction_scale = amount(1.0);
  return result;
}

Object Maker::object() {
  Object result;
  switch (choice(4)) {
    case 0:
      result.shape = make_plane(point(1.0), between(-2.5, -1.0));
      break;
    case 1: {
      const Vec3 corner = point(1.5);
      result.shape = make_box(corner, corner + Vec3(between(0.1, 2), between(0.1, 2), between(0.1, 2)));
      break;
    }
    case 2:
      result.shape = make_disc(point(1.0), point(1.0), between(0.5, 2.0), 0.0);
      break;
    default:
      result.shape = make_sphere(point(1.5), between(0.2, 1.2));
  }
  result.texture = texture();
  if (chance(0.2)) result.extras.change().interior_texture = texture();
  if (chance(0.7)) result.extras.change().interior = interior();
  result.double_illuminate = chance(0.2);
  result.no_shadow = chance(0.1);
  return result;
}

Object Maker::light() {
  Object result;
  result.kind = Object::Kind::light;
  Light& light = result.extras.change().light.change();
  light.position = point(4.0);
  light.color = color(1.0);
  if (chance(0.2)) light.color = light.color * -0.5f;
  light.shadowless = chance(0.2);
  if (chance(0.4)) {
    light.fade_distance = wild() && chance(0.2) ? -2.0 : between(0.5, 5.0);
    light.fade_power = between(0.5, 3.0);
  }
  return result;
}

std::unique_ptr<const Scene> Maker::make() {
  SceneBuilder builder;
  Settings& settings = builder.settings();
  settings.max_trace_level = 1 + choice(5);
  settings.adc_bailout = chance(0.3) ? 0.0 : chance(0.5) ? 1.0 / 255.0 : 0.05;
  settings.language_version = chance(0.3) ? 350 : 370;
  settings.ambient_light = color(1.0);
  settings.background = color(0.5);
  if (chance(0.1)) settings.atmosphere_ior = 1.1;
  Camera camera;
  camera.location = Vec3(0.3, 0.5, -4.0);
  look_at(camera, Vec3(0.0));
  builder.set_camera(camera);
  const TexturePtr plain = texture();
  const int objects = 3 + choice(5);
  for (int i = 0; i < objects; ++i) builder.add(object(), plain);
  const int lights = 1 + choice(5);
  for (int i = 0; i < lights; ++i) builder.add(light(), plain);
  return builder.build();
}

}  // namespace

RandomScene::RandomScene(std::uint32_t seed, Fancy fancy) : scene_(Maker(seed, fancy).make()) {
  accel_ = std::make_unique<Accel>(*scene_);
}

RayTask RandomScene::primary(double x, double y, std::uint32_t sample) {
  constexpr int kUnit = 1;
  const Ray ray = ray_through({scene_->camera, kUnit, kUnit}, x, y).value();
  RayTask task;
  task.origin = ray.origin;
  task.set_direction(PackedDirection(ray.direction));
  task.set_weight(Rgb(1.0f), 1.0f);
  task.sample = sample;
  task.medium = medium_at(*scene_, *media_, ray.origin);
  return task;
}

}  // namespace firstlight::render
