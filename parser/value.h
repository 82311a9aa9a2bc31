#pragma once

#include "render/camera/camera.h"
#include "render/math/color.h"
#include "render/math/transform.h"
#include "render/scene/object.h"
#include "render/texture/texture.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace firstlight::parser {

struct Array;
struct Macro;

/// A vector of 2 to 5 numbers, or a single number (size 1). `is_color` records that it was made by a colour keyword, which
/// decides what POV-Ray makes of it when it is declared.
struct Numbers {
  std::array<double, 5> values{};
  std::uint8_t size = 1;
  bool is_color = false;
};

/// `material { }`: what an object takes from it.
struct Material {
  render::TexturePtr texture;
  render::Transform texture_placement;
  render::TexturePtr interior_texture;
  std::shared_ptr<const render::Interior> interior;
};

/// Anything that `#declare` can name. Heavy things are shared and immutable; a copy is cheap.
using Value = std::variant<std::monostate,                              // declared but undefined
                           Numbers,                                     // float, vector, colour
                           std::string,                                 // string
                           std::shared_ptr<Array>,                      // array (passed and copied by POV-Ray's rules)
                           std::shared_ptr<const Macro>,                // macro
                           std::shared_ptr<const render::Object>,       // any object or light_source
                           std::shared_ptr<const render::Texture>,      // texture, its layers placed
                           std::shared_ptr<const render::Pigment>,      // pigment
                           std::shared_ptr<const render::Finish>,       // finish
                           std::shared_ptr<const render::Interior>,     // interior
                           std::shared_ptr<const Material>,             // material
                           std::shared_ptr<const render::ColorMap>,     // color_map
                           std::shared_ptr<const render::Camera>,       // camera
                           std::shared_ptr<const render::Transform>>;   // transform

/// The word a message uses for the kind of `value`: "float", "vector", "texture" ...
std::string_view kind_name(const Value& value);

}  // namespace firstlight::parser
