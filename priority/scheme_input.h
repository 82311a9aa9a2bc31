#pragma once

#include "render/film/film.h"
#include "render/function/program.h"
#include "render/scene/scene_index.h"

#include <functional>
#include <span>
#include <string_view>

namespace firstlight::priority {

/// The picture as far as a scheme may know it, beside the tasks.
struct SchemeInput {
  /// Makes a program of an expression over the named parameters, which are its arguments in their order.
  using Compile =
      std::function<render::CompileResult(std::string_view text, std::span<const std::string_view> parameters)>;

  render::SceneIndex scene = {};  ///< of a scene that outlives the scheme
  int width = 0;                  ///< pixels
  int height = 0;
  Compile compile = nullptr;  ///< empty: schemes with expressions are refused
  /// Knows which pixels the samples of anti-aliasing belong to; may be null.
  const render::Film* film = nullptr;
};

}  // namespace firstlight::priority
