#pragma once

#include "priority/order.h"
#include "render/scene/scene.h"
#include "render/scene/scene_index.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace firstlight::priority {

constexpr int kPictureWidth = 100;
constexpr int kPictureHeight = 80;

/// Six groups of objects, three lights, six levels; the eye in the origin. No geometry.
inline const render::Scene& scene_to_order() {
  using render::SurfaceKind;
  static const render::Scene kScene = [] {
    render::Scene scene;
    scene.settings.max_trace_level = 6;
    scene.camera.location = render::Vec3(0.0);
    scene.objects = {
        {{"Room"}, "plane", SurfaceKind::mirror, 1},  {{"Chair", "Leg"}, "cylinder", SurfaceKind::plain, 1},
        {{"Chair"}, "box", SurfaceKind::glossy, 3},   {{"Table", "Leg"}, "cylinder", SurfaceKind::plain, 5},
        {{"Glass"}, "sphere", SurfaceKind::clear, 1}, {{}, "sphere", SurfaceKind::plain, 1}};
    scene.lights.resize(3);
    scene.lights[0].color = render::Rgb(0.5f);
    scene.lights[0].position = render::Vec3(0.0, 10.0, 0.0);
    scene.lights[1].color = render::Rgb(1.0f, 0.2f, 0.1f);
    scene.lights[1].position = render::Vec3(0.0, 5.0, 0.0);
    scene.lights[2].color = render::Rgb(2.0f);
    scene.lights[2].position = render::Vec3(0.0, 90.0, 0.0);
    scene.light_names = {{"Lamp"}, {}, {"Sky", "Sun"}};
    return scene;
  }();
  return kScene;
}

inline SchemeInput scene_input() {
  SchemeInput input;
  input.scene = render::index_of(scene_to_order());
  input.width = kPictureWidth;
  input.height = kPictureHeight;
  return input;
}

inline std::shared_ptr<const Scheme> scheme_of(std::string_view text) {
  std::string error;
  const auto order = Order::parse(text, scene_input(), error);
  EXPECT_TRUE(order.has_value()) << text << ": " << error;
  return order ? order->scheme() : nullptr;
}

inline std::string error_of(std::string_view text) {
  std::string error;
  EXPECT_FALSE(Order::parse(text, scene_input(), error).has_value()) << text;
  return error;
}

/// Feelers go to the first light.
inline render::RayTask task(render::RayKind kind, float weight, int level = 0, int x = 0, int y = 0) {
  render::RayTask out;
  out.origin = render::Vec3(0.0);
  out.kind = kind;
  const render::Rgb light(weight * 0.5f, weight, weight * 0.25f);
  if (kind == render::RayKind::shadow) {
    out.set_feeler(0, render::PackedRgb(light));
  } else {
    out.set_weight(light, 1.0f);
  }
  out.level = static_cast<std::uint8_t>(level);
  out.sample = static_cast<std::uint32_t>(y * kPictureWidth + x);
  return out;
}

inline Key key_of(const Scheme& scheme, const render::RayTask& task) {
  Key key = kBuckets;
  scheme.keys({&task, 1}, {&key, 1});
  EXPECT_LT(key, scheme.key_count());
  return key;
}

}  // namespace firstlight::priority
