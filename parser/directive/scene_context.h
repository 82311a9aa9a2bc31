#pragma once

#include "parser/text/token.h"
#include "render/scene/scene_builder.h"
#include "render/texture/density_grid.h"
#include "render/texture/image_store.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace firstlight::parser {

class FontStore;

/// A scene's words about radiosity, for the checks when all is said.
struct RadiosityText {
  Token word;  ///< of the last block
  bool minimum_reuse = false, maximum_reuse = false;
};

/// Statements need this beside the text: the scene under construction and the defaults that `#default` sets.
struct SceneContext {
  explicit SceneContext(render::SceneBuilder& scene_builder) : builder(scene_builder) {}

  render::SceneBuilder& builder;
  /// One layer; `#default` replaces it. Never null; shared by all objects that use it.
  render::TexturePtr default_texture =
      std::make_shared<const render::Texture>(render::Texture{std::vector<render::TextureLayer>(1)});
  bool default_given = false;                  ///< there was a `#default`
  render::Shared<render::Finish> last_finish;  ///< see kept_once()
  render::Camera default_camera;
  render::Camera camera;  ///< the scene's so far; before version 3.5 a further camera statement goes on from it
  RadiosityText radiosity;
  render::ImageStore images;
  std::map<std::string, std::shared_ptr<const render::DensityGrid>> density_files;  ///< by path
  std::shared_ptr<FontStore> fonts;  ///< null until there is text
  std::uint64_t size = 0;  ///< objects in the scene so far, with all that they are made of
};

}  // namespace firstlight::parser
