#pragma once

#include "render/function/function.h"
#include "render/math/vec.h"
#include "render/texture/density_grid.h"
#include "render/texture/image_use.h"

#include <functional>
#include <memory>
#include <string>
#include <variant>

namespace firstlight::render {

struct Object;   // render/scene/object.h, which stands above textures
struct Pigment;  // render/texture/pigment.h

// Patterns take these beside their names. Defaults are POV-Ray 3.7's. [manual, "Patterns"]

struct AgateParameters {
  double turbulence = 1.0;  ///< agate_turb
};

struct BrickParameters {
  Vec3 size{8.0, 3.0, 4.5};
  double mortar = 0.5;
};

struct CrackleParameters {
  Vec3 form{-1.0, 1.0, 0.0};  ///< weights of the distances to the nearest, second and third point
  double metric = 2.0;        ///< distance = (|x|^m + |y|^m + |z|^m)^(1/m)
  double offset = 0.0;
  bool solid = false;
};

struct DensityFileParameters {
  std::string path;       ///< of the .df3 file, where it was found
  int interpolation = 0;  ///< 1: trilinear, 2: tricubic
  std::shared_ptr<const DensityGrid> grid = {};  ///< null: not read
};

struct FacetsParameters {
  double size = 0.1;
  double coords = 0.0;  ///< when not 0, cells of this size instead of facets by direction
  double metric = 2.0;
};

/// mandel, julia and magnet.
struct FractalParameters {
  int magnet = 0;      ///< 1 or 2: of the two magnetic models; 0: none
  bool julia = false;  ///< else mandel
  Vec2 start{0.0, 0.0};
  int iterations = 0;
  int exponent = 2;       ///< 0 for magnet
  int exterior_type = 1;  ///< 0 to 8
  double exterior_factor = 1.0;
  int interior_type = 0;  ///< 0 to 6
  double interior_factor = 1.0;
};

struct FunctionParameters {
  FunctionPtr function;  ///< of x, y and z
};

struct GradientParameters {
  Vec3 axis{0.0, 0.0, 0.0};
};

struct ImageParameters {
  std::shared_ptr<const ImageUse> image;
};

struct ObjectParameters {
  std::shared_ptr<const Object> object;       ///< value 1 inside, 0 outside
  std::function<bool(const Vec3&)> inside = {};  ///< of the object; empty: its geometry is not known
};

struct PavementParameters {
  int sides = 3;  ///< 3, 4 or 6
  int tiles = 1;
  int pattern = 1;
  int exterior = 0;
  int interior = 0;
  int form = 0;
};

struct PigmentParameters {
  std::shared_ptr<const Pigment> pigment;  ///< its grey is the value
};

struct QuiltedParameters {
  double control0 = 1.0;
  double control1 = 1.0;
};

struct SlopeParameters {
  Vec3 direction{0.0, 0.0, 0.0};  ///< or, if `to_point`, a place that the surface faces or not
  double low = 0.0;               ///< slopes from low to high become 0 to 1, unless both are 0
  double high = 0.0;
  Vec3 altitude{0.0, 0.0, 0.0};  ///< zero: only the slope counts
  double low_altitude = 0.0;
  double high_altitude = 0.0;
  bool to_point = false;
};

struct SpiralParameters {
  int arms = 0;
};

struct TilingParameters {
  int type = 1;  ///< 1 to 27
};

using PatternParameters =
    std::variant<std::monostate, AgateParameters, BrickParameters, CrackleParameters, DensityFileParameters,
                 FacetsParameters, FractalParameters, FunctionParameters, GradientParameters, ImageParameters,
                 ObjectParameters, PavementParameters, PigmentParameters, QuiltedParameters, SlopeParameters,
                 SpiralParameters, TilingParameters>;

}  // namespace firstlight::render
