#include "tests/priority/mirror_room.h"

#include "render/scene/scene_builder.h"
#include "render/shape/primitives.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace firstlight::priority {
namespace {

using namespace render;

TexturePtr texture_of(const FilteredColor& color, float reflection) {
  TextureLayer layer;
  layer.pigment.color = color;
  Finish finish;
  finish.reflection_min = finish.reflection_max = Rgb(reflection);
  finish.specular = 0.5;
  layer.finish = finish;
  Texture texture;
  texture.layers.push_back(std::move(layer));
  return std::make_shared<const Texture>(std::move(texture));
}

Object object_of(ShapePtr shape, TexturePtr texture) {
  Object object;
  object.shape = std::move(shape);
  object.texture = std::move(texture);
  return object;
}

class FlakeMaker {
 public:
  FlakeMaker(SceneBuilder& builder, int glass) : builder_(builder), glass_every_(glass) {}

  void add(const Vec3& center, double radius, const Vec3& axis, int depth) {
    const bool is_glass = glass_every_ > 0 && ++count_ % glass_every_ == 0;
    Object sphere = object_of(make_sphere(center, radius), is_glass ? glass_ : metal_);
    if (is_glass) sphere.extras.change().interior = Interior{.ior = 1.4};
    builder_.add(std::move(sphere), metal_);
    if (depth == 0) return;
    const Vec3 side = (std::abs(axis.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)).cross(axis).normalized();
    const Vec3 other = axis.cross(side);
    const auto child = [&](double turn, double lift) {
      const Vec3 direction = (side * std::cos(turn) + other * std::sin(turn)) * std::cos(lift) + axis * std::sin(lift);
      add(center + direction * (radius * 4.0 / 3.0), radius / 3.0, direction, depth - 1);
    };
    constexpr double kTurn = 3.14159265358979 / 3.0;
    for (int i = 0; i < 6; ++i) child(kTurn * i, 0.0);
    for (int i = 0; i < 3; ++i) child(kTurn * (2 * i + 0.5), 0.95);
  }

 private:
  SceneBuilder& builder_;
  const int glass_every_;
  int count_ = 0;
  TexturePtr metal_ = texture_of({Rgb(0.8f, 0.5f, 0.2f)}, 0.4f);
  TexturePtr glass_ = texture_of({Rgb(0.9f, 1.0f, 0.9f), 0.7f, 0.1f}, 0.1f);
};

}  // namespace

MirrorRoom::MirrorRoom(int depth, int glass, int max_trace_level, int lights) {
  SceneBuilder builder;
  builder.settings().max_trace_level = max_trace_level;
  Camera camera;
  camera.location = Vec3(1.0, 1.5, -4.5);
  look_at(camera, Vec3(0.0, 0.0, 0.0));
  builder.set_camera(camera);
  const TexturePtr mirror = texture_of({Rgb(0.3f, 0.35f, 0.4f)}, 0.5f);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-5.0, 5.0}) {
      Vec3 normal(0.0);
      normal[axis] = 1.0;
      builder.add(object_of(make_plane(normal, side), mirror), mirror);
    }
  }
  const Vec3 positions[] = {{4.0, 4.5, -4.0}, {-4.0, 3.0, -3.0}, {0.5, 4.8, 4.0}, {-3.0, -4.0, -4.5}};
  for (const Vec3& position : std::span(positions).first(static_cast<std::size_t>(lights))) {
    Object light;
    light.kind = Object::Kind::light;
    light.extras.change().light.change().position = position;
    light.extras.change().light.change().color = Rgb(0.5f, 0.6f, 0.55f);
    builder.add(light, mirror);
  }
  FlakeMaker(builder, glass).add(Vec3(0.0), 1.0, Vec3(0.0, 1.0, 0.0), depth);
  scene_ = builder.build();
  accel_ = std::make_unique<Accel>(*scene_);
}

TraceContext MirrorRoom::context() {
  media_ = std::make_unique<MediumTable>();
  return {*scene_, *accel_, *media_};
}

}  // namespace firstlight::priority
