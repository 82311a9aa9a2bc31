#pragma once

#include "parser/text/token.h"
#include "render/camera/camera.h"
#include "render/function/function.h"
#include "render/function/spline.h"
#include "render/math/color.h"
#include "render/math/shared.h"
#include "render/math/transform.h"
#include "render/scene/atmosphere.h"
#include "render/scene/object.h"
#include "render/texture/media.h"
#include "render/texture/texture.h"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace firstlight::parser {

struct Array;
class DataFile;
struct Dictionary;
struct Macro;
class TokenFile;

/// A vector of 2 to 5 numbers, or a single number (size 1). `is_color` records that it was made by a colour keyword,
/// which decides what POV-Ray makes of it when it is declared.
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
  std::optional<render::Shared<render::Interior>> interior;
};

/// Anything that `#declare` can name. Heavy things are shared and immutable; a copy is cheap.
using Value = std::variant<std::monostate,                             // declared but undefined
                           Numbers,                                    // float, vector, colour
                           std::string,                                // string
                           std::shared_ptr<Array>,                     // array (passed and copied by POV-Ray's rules)
                           std::shared_ptr<const Macro>,               // macro
                           std::shared_ptr<const render::Object>,      // any object or light_source
                           std::shared_ptr<const render::Texture>,     // texture, its layers placed
                           std::shared_ptr<const render::Pigment>,     // pigment
                           std::shared_ptr<const render::Finish>,      // finish
                           std::shared_ptr<const render::Interior>,    // interior
                           std::shared_ptr<const Material>,            // material
                           std::shared_ptr<const render::ColorMap>,    // color_map
                           std::shared_ptr<const render::Normal>,      // normal
                           std::shared_ptr<const render::Density>,     // density
                           std::shared_ptr<const render::Media>,       // media
                           std::shared_ptr<const render::PigmentMap>,  // pigment_map
                           std::shared_ptr<const render::NormalMap>,   // normal_map
                           std::shared_ptr<const render::SlopeMap>,    // slope_map
                           std::shared_ptr<const render::TextureMap>,  // texture_map
                           std::shared_ptr<const render::DensityMap>,  // density_map
                           std::shared_ptr<const render::Camera>,      // camera
                           std::shared_ptr<const render::Transform>,   // transform
                           render::FunctionPtr,                        // function
                           std::shared_ptr<const render::Spline>,      // spline
                           std::shared_ptr<Dictionary>,                // dictionary
                           std::shared_ptr<DataFile>,                  // what #fopen opens
                           std::shared_ptr<const render::Fog>,         // fog
                           std::shared_ptr<const render::Rainbow>,     // rainbow
                           std::shared_ptr<const render::SkySphere>>;  // sky_sphere

/// `array [2][3]`: elements in the order of the text; std::monostate where nothing has been stored. All elements are of
/// one kind, that of the first one stored, unless the array is mixed. One without sizes grows as it is written to.
/// Memory   Elements stay where they are when it grows: there may be references to them.
struct Array {
  std::vector<std::uint32_t> sizes;
  std::deque<Value> elements;
  bool mixed = false;
  bool grows = false;    ///< then it has one dimension
  std::size_t kind = 0;  ///< kind_of() its elements; 0 until the first is stored
};

/// `dictionary { .Key: value }`, of the language after 3.7. Entries stay where they are, for there may be references.
struct Dictionary {
  std::map<std::string, std::shared_ptr<Value>, std::less<>> entries;
};

/// `#macro Name(A, B) ... #end`: the tokens between, to be read again at each call.
struct Macro {
  std::string_view name;
  struct Parameter {
    std::uint32_t symbol = 0;
    bool optional = false;  ///< may be left out; then the name means what it means outside
  };
  std::vector<Parameter> parameters;
  const TokenFile* file = nullptr;
  std::uint32_t begin = 0, end = 0;  ///< into the file's tokens
};

/// Whether `next` behind a name with this value picks a part of it: `Array[1]`, `Dictionary.Key`.
bool picks_part(const Value& value, const Token& next);
/// How deeply arrays and dictionaries are nested in it: 0 when it is none.
std::uint32_t depth_of(const Value& value);
/// Bytes that it holds beside itself, in strings, arrays and dictionaries.
std::size_t bytes_of(const Value& value);
/// A copy that shares nothing that can be changed.
Value copy_of(const Value& value);
/// Number that tells kinds of value apart, numbers by their count.
std::size_t kind_of(const Value& value);
/// The word a message uses for the kind of `value`: "float", "vector", "texture" ...
std::string_view kind_name(const Value& value);

}  // namespace firstlight::parser
