#pragma once

#include "render/feature/feature.h"
#include "render/math/columns.h"
#include "render/math/noise.h"
#include "render/math/transform.h"
#include "render/math/vec.h"

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace firstlight::render {

// Ways to bend the space that a pattern is in. Defaults are POV-Ray 3.7's. [manual, "Warps"]

struct Turbulence {
  Vec3 amount{0.0, 0.0, 0.0};
  int octaves = 6;  ///< 1 to 10
  double omega = 0.5;
  double lambda = 2.0;
};

/// The octaves of the noise that it moves points by.
Octaves octaves_of(const Turbulence& turbulence);

struct RepeatWarp {
  int axis = 0;
  double width = 0.0;
  Vec3 offset{0.0, 0.0, 0.0};
  Vec3 flip{1.0, 1.0, 1.0};  ///< -1: mirrored in every other block
};

struct BlackHoleWarp {
  Vec3 center{0.0, 0.0, 0.0};
  double radius = 1.0;
  double strength = 1.0;
  double falloff = 2.0;
  bool inverted = false;
  int type = 0;
  std::optional<Vec3> repeat;
  std::optional<Vec3> turbulence;  ///< of the centres, when repeated
};

struct CylindricalWarp {
  Vec3 orientation{0.0, 0.0, 1.0};
  double distance_exponent = 0.0;
};

struct SphericalWarp {
  Vec3 orientation{0.0, 0.0, 1.0};
  double distance_exponent = 0.0;
};

struct ToroidalWarp {
  Vec3 orientation{0.0, 0.0, 1.0};
  double distance_exponent = 0.0;
  double major_radius = 1.0;
};

struct PlanarWarp {
  Vec3 orientation{0.0, 0.0, 1.0};
  double offset = 0.0;
};

struct CubicWarp {};

using Warp = std::variant<Transform, Turbulence, RepeatWarp, BlackHoleWarp, CylindricalWarp, SphericalWarp,
                          ToroidalWarp, PlanarWarp, CubicWarp>;

/// The way from a pattern's own space to the space that it is placed in: transformations and warps as they follow each
/// other in the scene text.
struct Warps {
  std::vector<Warp> steps;               ///< neighbouring transformations are one
  std::optional<Turbulence> turbulence;  ///< the word outside `warp`: nearest to the pattern, wherever it stands
  FeatureUses unrendered = {};

  void transform(const Transform& next);
  /// Moves points of the space that the pattern is placed in, `count` of them, to the pattern's own. `moves`: by the word
  /// turbulence too.
  void to_pattern(Columns3<double>& points, std::size_t count, bool moves = true) const;
  Vec3 to_pattern(const Vec3& point, bool moves = true) const;
};

}  // namespace firstlight::render
