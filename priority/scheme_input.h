#pragma once

#include "render/film/film.h"
#include "render/function/program.h"
#include "render/scene/scene.h"

#include <functional>
#include <span>
#include <string_view>

namespace firstlight::priority {

/// What a scheme may know of the picture beside the tasks. The scene outlives the scheme.
struct SchemeInput {
  /// Makes a program of an expression over the named parameters, which are its arguments in their order.
  using Compile =
      std::function<render::CompileResult(std::string_view text, std::span<const std::string_view> parameters)>;

  const render::Scene* scene = nullptr;
  int width = 0;  ///< pixels
  int height = 0;
  Compile compile = nullptr;  ///< empty: schemes with expressions are refused
  /// Knows which pixels the samples of anti-aliasing belong to; may be null.
  const render::Film* film = nullptr;
  const render::Camera* other_camera = nullptr;  ///< that the scene is seen by instead of its own

  /// Where the scene is seen from, more or less: the rays of some cameras begin at many places.
  const render::Vec3& eye() const { return (other_camera != nullptr ? *other_camera : scene->camera).location; }
};

}  // namespace firstlight::priority
