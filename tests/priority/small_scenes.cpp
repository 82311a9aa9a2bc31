#include "tests/priority/small_scenes.h"

#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"
#include "render/texture/patterning.h"

#include <utility>

namespace firstlight::priority {
namespace {

using namespace render;

TexturePtr texture_of(const FilteredColor& color, const Finish& finish, const FilteredColor* other = nullptr) {
  TextureLayer layer;
  layer.pigment.color = color;
  if (other != nullptr) {
    layer.pigment.pattern = PigmentPattern{patterned(PatternKind::checker), {{0.0, color}, {1.0, *other}}};
  }
  layer.finish = finish;
  Texture texture;
  texture.layers.push_back(std::move(layer));
  return std::make_shared<const Texture>(std::move(texture));
}

Finish mirror(float reflection, double exponent = 1.0) {
  Finish finish;
  finish.specular = 0.4;
  finish.reflection_min = finish.reflection_max = Rgb(reflection);
  finish.reflection_exponent = exponent;
  return finish;
}

class Maker {
 public:
  explicit Maker(int levels) {
    builder_.settings().max_trace_level = levels;
    builder_.settings().background = Rgb(0.1f, 0.15f, 0.3f);
    use(CameraKind::perspective);
  }

  void use(CameraKind kind, const FocalBlur& blur = {}) {
    Camera camera;
    camera.kind = kind;
    camera.blur = blur;
    camera.location = Vec3(0.5, 1.2, -4.0);
    look_at(camera, Vec3(0.0));
    builder_.set_camera(camera);
  }

  void add(std::string name, ShapePtr shape, TexturePtr texture, const std::optional<Interior>& interior = {}) {
    Object object;
    if (!name.empty()) object.extras.change().names.push_back(std::move(name));
    object.shape = std::move(shape);
    object.texture = texture;
    object.extras.change().interior = interior;
    builder_.add(object, texture);
  }
  void add(const Light& light) {
    Object object;
    object.kind = Object::Kind::light;
    object.extras.change().light = light;
    builder_.add(object, nullptr);
  }
  void add_light(const Vec3& position, const Rgb& color, double fade_distance = 0.0) {
    Light light;
    light.position = position;
    light.color = color;
    light.fade_distance = fade_distance;
    light.fade_power = fade_distance > 0.0 ? 2.0 : 0.0;
    add(light);
  }
  std::unique_ptr<const Scene> finished() { return builder_.build(); }

 private:
  SceneBuilder builder_;
};

}  // namespace

render::TraceContext SmallScene::context() {
  media_ = std::make_unique<MediumTable>();
  return {*scene_, *accel_, *media_};
}

namespace {

std::unique_ptr<const Scene> hall_seen_by(CameraKind kind, const FocalBlur& blur = {}) {
  Maker maker(5);
  maker.use(kind, blur);
  const FilteredColor brown{Rgb(0.4f, 0.25f, 0.1f)};
  const FilteredColor grey{Rgb(0.6f)};
  maker.add("Floor", make_plane({0, 1, 0}, -1.0), texture_of(brown, mirror(0.2f), &grey));
  maker.add("", make_plane({0, 0, 1}, 3.0), texture_of(grey, mirror(0.7f)));
  maker.add("", make_plane({0, 0, 1}, -6.0), texture_of(grey, mirror(0.6f)));
  maker.add("Ball", make_sphere({-0.6, 0.0, 0.0}, 0.8), texture_of(brown, mirror(0.5f)));
  maker.add("Glass", make_sphere({1.0, -0.4, -0.5}, 0.6), texture_of({Rgb(0.9f), 0.8f, 0.0f}, mirror(0.1f)),
            Interior{.ior = 1.5});
  for (int i = 0; i < 5; ++i) maker.add_light(Vec3(-4.0 + 2.0 * i, 4.0, -2.0 + i), Rgb(0.2f, 0.25f, 0.1f * i), 0.0);
  return maker.finished();
}

}  // namespace

SmallScene hall_of_mirrors() { return {"hall of mirrors", hall_seen_by(CameraKind::perspective)}; }

SmallScene hall_through_a_lens() {
  FocalBlur blur;
  blur.aperture = 0.3;
  blur.samples = 5;
  blur.variance = 1e-3;
  blur.focal_distance = 3.0;
  return {"hall through a lens", hall_seen_by(CameraKind::perspective, blur)};
}

SmallScene hall_through_a_fisheye() { return {"hall through a fisheye", hall_seen_by(CameraKind::fisheye)}; }

SmallScene coloured_glass() {
  Maker maker(6);
  const FilteredColor white{Rgb(0.9f)};
  const FilteredColor red_glass{Rgb(1.0f, 0.3f, 0.2f), 0.8f, 0.1f};
  const FilteredColor blue_glass{Rgb(0.2f, 0.4f, 1.0f), 0.6f, 0.3f};
  maker.add("Floor", make_plane({0, 1, 0}, -1.0), texture_of(white, Finish()));
  maker.add("Glass", make_box({-1.4, -0.9, -0.6}, {-0.4, 0.6, 0.4}), texture_of(red_glass, mirror(0.15f)),
            Interior{.ior = 1.3, .fade_distance = 1.0, .fade_power = 1.0, .fade_color = Rgb(0.8f, 0.5f, 0.4f)});
  maker.add("Ball", make_sphere({0.7, -0.2, 0.2}, 0.8), texture_of(blue_glass, mirror(0.1f), &red_glass),
            Interior{.ior = 1.5});
  maker.add("", make_disc({0.0, 0.9, -0.5}, {0.2, 1, 0.1}, 0.7, 0.2), texture_of(blue_glass, Finish()));  // goes on
  maker.add_light({3, 5, -4}, Rgb(0.9f, 0.8f, 0.7f));
  maker.add_light({-4, 3, -2}, Rgb(0.4f, 0.5f, 0.9f), 4.0);
  return {"coloured glass", maker.finished()};
}

SmallScene mirrors_with_exponents() {
  Maker maker(4);
  const FilteredColor grey{Rgb(0.5f, 0.5f, 0.6f)};
  const FilteredColor dark{Rgb(0.1f)};
  maker.add("Floor", make_plane({0, 1, 0}, -1.0), texture_of(grey, mirror(0.6f, 0.7), &dark));
  maker.add("Ball", make_sphere({-0.7, 0.0, 0.3}, 1.0), texture_of(dark, mirror(0.8f, 1.8)));
  maker.add("Glass", make_sphere({0.9, -0.2, -0.4}, 0.7), texture_of({Rgb(1.0f), 0.7f, 0.2f}, mirror(0.2f)),
            Interior{.ior = 1.4});
  maker.add_light({3, 5, -4}, Rgb(0.8f));
  maker.add_light({-3, 4, -3}, Rgb(0.5f, 0.3f, 0.2f));
  return {"mirrors with exponents", maker.finished()};
}

SmallScene lights_of_many_kinds() {
  Maker maker(4);
  const FilteredColor brown{Rgb(0.6f, 0.4f, 0.2f)};
  maker.add("Floor", make_plane({0, 1, 0}, -1.0), texture_of(brown, mirror(0.3f)));
  maker.add("Ball", make_sphere({-0.6, 0.0, 0.0}, 0.8), texture_of(brown, mirror(0.4f)));
  maker.add("Glass", make_sphere({1.0, -0.4, -0.5}, 0.6), texture_of({Rgb(0.9f, 0.7f, 0.5f), 0.8f, 0.0f}, mirror(0.1f)),
            Interior{.ior = 1.3});
  Light area;
  area.position = Vec3(-3.0, 4.0, -3.0);
  area.color = Rgb(0.5f, 0.45f, 0.4f);
  area.area = AreaLight{{2.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, 5, 4};
  area.adaptive = 0;
  area.jitter = true;
  maker.add(area);
  area.area_illumination = true;
  area.position = Vec3(3.0, 3.0, -2.0);
  maker.add(area);
  Light beam;
  beam.position = Vec3(1.0, 4.0, -3.0);
  beam.color = Rgb(0.3f, 0.4f, 0.6f);
  beam.point_at = Vec3(0.0, -1.0, 0.0);
  beam.kind = LightKind::spotlight;
  beam.radius = 10.0;
  beam.falloff = 25.0;
  maker.add(beam);
  beam.kind = LightKind::point;
  beam.parallel = true;
  beam.position = Vec3(0.5, 0.0, 0.0);
  maker.add(beam);
  return {"lights of many kinds", maker.finished()};
}

std::vector<SmallScene> small_scenes() {
  std::vector<SmallScene> scenes;
  scenes.push_back(hall_of_mirrors());
  scenes.push_back(hall_through_a_fisheye());
  scenes.push_back(hall_through_a_lens());
  scenes.push_back(coloured_glass());
  scenes.push_back(mirrors_with_exponents());
  scenes.push_back(lights_of_many_kinds());
  return scenes;
}

}  // namespace firstlight::priority
