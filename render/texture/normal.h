#pragma once

#include "render/feature/feature.h"
#include "render/texture/patterning.h"

#include <memory>

namespace firstlight::render {

/// Where a slope map says how high the surface is, and how steep.
struct SlopePoint {
  double height = 0.0;
  double slope = 0.0;
};

struct Normal;
using NormalMap = BlendMap<Normal>;
using SlopeMap = BlendMap<SlopePoint>;

/// How a surface seems uneven where it is not. Plain data. [POV-Ray 3.7 manual, "Normal"]
struct Normal {
  Patterning pattern = {};
  double amount = 0.5;                            ///< bump_size
  double accuracy = 0.02;                         ///< step of the differences that tilts are made of
  std::shared_ptr<const SlopeMap> slopes = {};    ///< shape of the bumps; null: the pattern as it is
  std::shared_ptr<const NormalMap> normals = {};  ///< instead of `slopes`
};

/// Whether any part of it goes by a surface's own coordinates.
bool goes_by_uv(const Normal& normal);
/// Adds what the normal asks for that cannot be rendered.
void gather(const Normal& normal, FeatureUses& uses);

}  // namespace firstlight::render
