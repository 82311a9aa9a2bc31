#pragma once

#include "render/math/vec.h"
#include "render/scene/extent.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace firstlight::render {

class MediumTable;
struct Scene;
class Solid;

/// Finds the medium in which a ray begins at `point`.
std::uint32_t medium_at(const Scene& scene, MediumTable& media, const Vec3& point);

/// Whether a ray that begins somewhere in `origins` may begin in the solid; for a box that is one point, whether it
/// does.
bool may_hold_start(const Solid& solid, const Box3& origins);

/// Media of rays that begin in a part of space: only those solids are asked that may hold any of their origins, and
/// none where all rays begin in one point.
///
/// Cost     of() that of Solid::holds_start() for each of these solids.
/// Threads  of() may be called from any thread.
class StartMedium {
 public:
  /// Pre: scene and media outlive it.
  StartMedium(const Scene& scene, MediumTable& media, const Box3& origins);

  std::uint32_t of(const Vec3& origin) const { return holders_.empty() ? everywhere_ : ask(origin); }

 private:
  struct Holder {
    const Solid* solid;
    std::optional<Extent> extent;  ///< where it is asked
  };

  std::uint32_t ask(const Vec3& origin) const;

  MediumTable& media_;
  std::uint32_t everywhere_;  ///< where nothing holds an origin
  std::vector<Holder> holders_;  ///< in the scene's order
};

}  // namespace firstlight::render
