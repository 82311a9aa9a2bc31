#include "render/accel/clear_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace firstlight::render {
namespace {

constexpr std::size_t kMostBits = std::size_t{512} * 1024 * 8;
constexpr int kMostCells = 256;  ///< along an edge
constexpr int kFewestCells = 16;
/// What is seen through so few cells is not looked at more closely.
constexpr std::size_t kFewCells = 4;
/// Cells that a box reaches beyond its edge: far more than what is lost by computing with floats.
constexpr double kRoom = 1e-3;

bool casts_shadow(std::uint8_t hidden_from) { return (hidden_from & kHiddenFromShadow) == 0; }

FloatBox box_at(const float (*bounds)[kTreeWidth], std::size_t slot) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = bounds[2 * axis][slot];
    box.high[axis] = bounds[2 * axis + 1][slot];
  }
  return box;
}

/// The axis that a face lies across, its sign, and the axes along its edges.
struct Face {
  int axis, u, v;
  bool negative;
};

/// Cells of one face, from the first to the last; none where the first is beyond the last.
struct Rectangle {
  int u0 = 0;
  int u1 = -1;
  int v0 = 0;
  int v1 = -1;

  std::size_t area() const {
    return u1 < u0 || v1 < v0 ? 0 : static_cast<std::size_t>(u1 - u0 + 1) * static_cast<std::size_t>(v1 - v0 + 1);
  }
};

constexpr std::array<Face, 6> kCube{
    {{0, 1, 2, false}, {0, 1, 2, true}, {1, 2, 0, false}, {1, 2, 0, true}, {2, 0, 1, false}, {2, 0, 1, true}}};

/// The cells along one edge through which [low, high] is seen, at depths from `near` to `far`.
std::pair<int, int> cells_along(double low, double high, double near, double far, int side) {
  const double least = near > 0.0 ? std::min(low / near, low / far) : low < 0.0 ? -1.0 : low / far;
  const double most = near > 0.0 ? std::max(high / near, high / far) : high > 0.0 ? 1.0 : high / far;
  const double half = 0.5 * side;
  const double first = (least + 1.0) * half - kRoom;
  const double last = (most + 1.0) * half + kRoom;
  if (!(first <= side && last >= 0.0)) return {0, -1};
  const auto cell = [&](double place) { return static_cast<int>(std::clamp(place, 0.0, side - 1.0)); };
  return {cell(first), cell(last)};
}

/// The cells of each face that a box is seen through, its corners given from the light.
std::array<Rectangle, 6> seen_through(const Vec3& low, const Vec3& high, int side) {
  std::array<Rectangle, 6> cells;
  for (std::size_t f = 0; f < kCube.size(); ++f) {
    const Face& face = kCube[f];
    const double near = face.negative ? -high[face.axis] : low[face.axis];
    const double far = face.negative ? -low[face.axis] : high[face.axis];
    if (!(far > 0.0)) continue;
    const auto [u0, u1] = cells_along(low[face.u], high[face.u], near, far, side);
    const auto [v0, v1] = cells_along(low[face.v], high[face.v], near, far, side);
    cells[f] = {u0, u1, v0, v1};
  }
  return cells;
}

std::array<Rectangle, 6> seen_through(const FloatBox& box, const Vec3& light, int side) {
  return seen_through(Vec3(box.low[0], box.low[1], box.low[2]) - light,
                      Vec3(box.high[0], box.high[1], box.high[2]) - light, side);
}

std::size_t count_of(const std::array<Rectangle, 6>& cells) {
  std::size_t count = 0;
  for (const Rectangle& rectangle : cells) count += rectangle.area();
  return count;
}

}  // namespace

ClearDirections::ClearDirections(const Leaves& leaves, std::span<const Light> lights) {
  // What has no bounds is seen everywhere.
  const bool is_open = std::ranges::all_of(leaves.beside, [&](ChildRef ref) {
    switch (ref.kind()) {
      case ChildKind::box:
        return !casts_shadow(leaves.boxes[ref.index()].head.hidden_from);
      case ChildKind::solid:
        return !casts_shadow(leaves.solids[ref.index()].head.hidden_from);
      default:
        return false;
    }
  });
  if (lights.empty() || !is_open) return;
  side_ = kMostCells;
  while (side_ >= kFewestCells && lights.size() * cells_of_cube() > kMostBits) side_ /= 2;
  if (side_ < kFewestCells) {
    side_ = 0;
    return;
  }
  words_.resize((lights.size() * cells_of_cube() + 31) / 32);
  if (leaves.tree.nodes().empty()) return;
  for (std::size_t l = 0; l < lights.size(); ++l) {
    mark_children(leaves, 0, l * cells_of_cube(), lights[l].position);
  }
}

void ClearDirections::mark_children(const Leaves& leaves, std::size_t node, std::size_t cube, const Vec3& light) {
  const WideNode& opened = leaves.tree.nodes()[node];
  for (std::size_t slot = 0; slot < kTreeWidth; ++slot) {
    const FloatBox box = box_at(opened.bounds, slot);
    if (box.low[0] > box.high[0]) continue;
    const ChildRef ref = opened.child[slot];
    switch (ref.kind()) {
      case ChildKind::node:
        if (count_of(seen_through(box, light, side_)) <= kFewCells) {
          mark(box, cube, light);
        } else {
          mark_children(leaves, ref.index(), cube, light);
        }
        break;
      case ChildKind::sphere: {
        const SphereBlock& block = leaves.sphere_blocks[ref.index()];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (block.radius_squared[lane] >= 0.0 && casts_shadow(block.hidden_from[lane])) {
            mark(box_at(block.bounds, lane), cube, light);
          }
        }
        break;
      }
      case ChildKind::box:
        if (casts_shadow(leaves.boxes[ref.index()].head.hidden_from)) mark(box, cube, light);
        break;
      case ChildKind::solid:
        if (casts_shadow(leaves.solids[ref.index()].head.hidden_from)) mark(box, cube, light);
        break;
    }
  }
}

void ClearDirections::mark(const FloatBox& box, std::size_t cube, const Vec3& light) {
  const std::array<Rectangle, 6> cells = seen_through(box, light, side_);
  const auto side = static_cast<std::size_t>(side_);
  for (std::size_t f = 0; f < cells.size(); ++f) {
    for (int v = cells[f].v0; v <= cells[f].v1; ++v) {
      const std::size_t row = cube + (f * side + static_cast<std::size_t>(v)) * side;
      for (int u = cells[f].u0; u <= cells[f].u1; ++u) {
        const std::size_t cell = row + static_cast<std::size_t>(u);
        words_[cell / 32] |= std::uint32_t{1} << cell % 32;
      }
    }
  }
}

}  // namespace firstlight::render
