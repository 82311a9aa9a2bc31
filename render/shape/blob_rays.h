#pragma once

#include "render/math/box_tree.h"
#include "render/math/ray_columns.h"
#include "render/math/transform.h"
#include "render/shape/blob_element.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace firstlight::render {

/// The elements of a blob, as rays ask for them.
struct BlobField {
  double threshold;
  std::span<const BlobElement> elements;
  const BoxTree* tree;  ///< over the elements' boxes; null: all are asked
};

struct BlobCrossing {
  std::size_t ray;
  double depth;
};

/// Appends where rays of a block cross the surface: of each ray its crossings in ascending order. `transform` leads from
/// the blob's space to that of the rays. If `low` is given, a ray is left when one of its crossings lies beyond it.
void meet_blob(const BlobField& field, const Transform& transform, const RayColumns& rays, std::uint64_t who,
               const Column<double>* low, std::vector<BlobCrossing>& out);

}  // namespace firstlight::render
