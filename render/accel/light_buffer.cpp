#include "render/accel/light_buffer.h"

#include "render/math/interrupt.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr int kMostCells = 512;  ///< along an edge
constexpr int kFewestCells = 4 * LightBuffer::kTile;
constexpr std::size_t kMostTiles = std::size_t{1} << 17;      ///< of all cubes: to stay near the processor
constexpr std::size_t kMostOpenTiles = std::size_t{1} << 13;  ///< with cells of their own
/// Things seen through cells: building must take little time beside tracing.
constexpr std::size_t kMostMarks = std::size_t{4} << 20;
constexpr std::size_t kFewMarks = std::size_t{1} << 16;  ///< for a scene of a few things
constexpr std::size_t kMarksOfOne = 32;                  ///< more for each thing and light
/// A thing seen through so few cells is not looked at more closely.
constexpr std::size_t kFewCells = 4;

constexpr double kNearer = 1.0 - 1e-6;  ///< room of distances
constexpr double kFarther = 1.0 + 1e-6;

bool casts_shadow(std::uint8_t hidden_from) { return (hidden_from & kHiddenFromShadow) == 0; }

FloatBox box_at(const float (*bounds)[kTreeWidth], std::size_t slot) {
  FloatBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = bounds[2 * axis][slot];
    box.high[axis] = bounds[2 * axis + 1][slot];
  }
  return box;
}

Vec3 center_of(const SphereBlock& block, std::size_t lane) {
  return {block.center[0][lane], block.center[1][lane], block.center[2][lane]};
}

/// A thing without bounds is seen everywhere.
bool all_have_bounds(const Leaves& leaves) {
  return std::ranges::all_of(leaves.beside, [&](ChildRef ref) {
    return ref.kind() != ChildKind::sphere && !casts_shadow(leaves.head(ref).hidden_from);
  });
}

}  // namespace

/// Marks what is seen from one light after the other.
class LightBuffer::Builder {
 public:
  Builder(LightBuffer& buffer, const Leaves& leaves) : buffer_(buffer), leaves_(leaves) {}

  /// How many marks all that is seen from a light would take; not much more than `most`, if it would be more.
  std::size_t measure(const Vec3& light, std::size_t most) {
    light_ = light;
    return leaves_.tree.nodes().empty() ? 0 : measure_children(0, most);
  }

  /// False: there is too much to be marked.
  bool mark_cube(std::size_t number, const Vec3& light) {
    first_tile_ = number * buffer_.tiles_of_cube();
    around_ = &buffer_.around_[number];
    *around_ = Around();
    light_ = light;
    return leaves_.tree.nodes().empty() || mark_children(0);
  }

 private:
  struct Seen {
    float first;
    float dark = FloatBox::kInfinity;
    std::uint32_t sphere = kNoIndex;
  };

  std::size_t measure_children(std::size_t node, std::size_t most) const {
    const WideNode& opened = leaves_.tree.nodes()[node];
    std::size_t marks = 0;
    for (std::size_t slot = 0; slot < kTreeWidth && marks < most; ++slot) {
      const FloatBox box = box_at(opened.bounds, slot);
      if (box.low[0] > box.high[0]) continue;
      const ChildRef ref = opened.child[slot];
      const std::size_t cells = CubeCells::count_of(seen_through(box));
      if (cells <= kFewCells) {
        marks += cells;
      } else if (ref.kind() == ChildKind::node) {
        marks += measure_children(ref.index(), most - marks);
      } else if (ref.kind() == ChildKind::sphere) {
        const SphereBlock& block = leaves_.sphere_blocks[ref.index()];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (block.radius_squared[lane] >= 0.0 && !is_in(block, lane)) {
            marks += CubeCells::count_of(seen_through(box_at(block.bounds, lane)));
          }
        }
      } else if (distance_to(box) > 0.0) {
        marks += cells;
      }
    }
    return marks;
  }

  /// 0: the light is in it.
  double distance_to(const FloatBox& box) const {
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double beside = std::max({box.low[axis] - light_[axis], light_[axis] - box.high[axis], 0.0});
      square += beside * beside;
    }
    return std::sqrt(square);
  }
  /// Whether the light is in a sphere.
  bool is_in(const SphereBlock& block, std::size_t lane) const {
    const Vec3 way = center_of(block, lane) - light_;
    return way.dot(way) < block.radius_squared[lane];
  }

  bool mark_children(std::size_t node) {
    const WideNode& opened = leaves_.tree.nodes()[node];
    for (std::size_t slot = 0; slot < kTreeWidth; ++slot) {
      const FloatBox box = box_at(opened.bounds, slot);
      if (box.low[0] > box.high[0]) continue;
      if (!mark_child(opened.child[slot], box)) return false;
    }
    return true;
  }

  bool mark_child(ChildRef ref, const FloatBox& box) {
    switch (ref.kind()) {
      case ChildKind::node:
        return CubeCells::count_of(seen_through(box)) <= kFewCells ? mark(box) : mark_children(ref.index());
      case ChildKind::sphere: {
        const SphereBlock& block = leaves_.sphere_blocks[ref.index()];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (block.radius_squared[lane] < 0.0 || !casts_shadow(block.hidden_from[lane])) continue;
          if (!mark_sphere(ref.index(), lane)) return false;
        }
        return true;
      }
      case ChildKind::box:
        return !casts_shadow(leaves_.head(ref).hidden_from) || mark_box(leaves_.boxes[ref.index()]);
      default:
        return !casts_shadow(leaves_.head(ref).hidden_from) || mark(box);
    }
  }

  CubeCells::Rectangles seen_through(const FloatBox& box) const {
    return buffer_.cube_.seen_through(Vec3(box.low[0], box.low[1], box.low[2]) - light_,
                                      Vec3(box.high[0], box.high[1], box.high[2]) - light_);
  }

  /// Something in the box that may be of any form.
  bool mark(const FloatBox& box) {
    const double distance = distance_to(box);
    if (distance == 0.0) {
      around_->limit = 0.0;
      return true;
    }
    return mark(seen_through(box), {static_cast<float>(distance * kNearer)});
  }

  bool mark(const CubeCells::Rectangles& cells, const Seen& seen) {
    marks_ += CubeCells::count_of(cells);
    if (marks_ > kMostMarks) return false;
    for (std::size_t f = 0; f < cells.size(); ++f) {
      for (int v = cells[f].v0; v <= cells[f].v1; ++v) {
        for (int u = cells[f].u0; u <= cells[f].u1; ++u) {
          if (!see(f, u, v, seen)) return false;
        }
      }
    }
    return true;
  }

  /// From within, a box is its walls.
  bool mark_box(const BoxLeaf& leaf) {
    const auto& [low, high] = leaf.box;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(light_[axis] > low[axis] + 2.0 * kShadowGap && light_[axis] < high[axis] - 2.0 * kShadowGap)) {
        return mark(leaf.bounds);
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 normal(0.0);
      normal[axis] = 1.0;
      around_->walls.push_back({normal, -low[axis], {}});
      around_->walls.push_back({normal, -high[axis], {}});
    }
    return true;
  }

  /// The cells through which a ball is seen have rays that pass its centre at distances that differ little.
  bool mark_sphere(std::size_t number, std::size_t lane) {
    const SphereBlock& block = leaves_.sphere_blocks[number];
    const double square = block.radius_squared[lane];
    const double radius = std::sqrt(square);
    const Vec3 way = center_of(block, lane) - light_;
    const double distance = way.length();
    const FloatBox box = box_at(block.bounds, lane);
    if (!(distance > radius * kFarther + 2.0 * kShadowGap)) {
      around_->limit = std::min(around_->limit, std::max(radius * kNearer - distance, 0.0));
      return true;
    }
    const CubeCells::Rectangles cells = seen_through(box);
    marks_ += CubeCells::count_of(cells);
    if (marks_ > kMostMarks) return false;

    const bool is_opaque = (block.opaque >> lane & 1u) != 0;
    Seen seen{0.0f};
    if (is_opaque) seen.sphere = static_cast<std::uint32_t>(number * kLanes + lane);
    // Not where it is so small, or so far away, that roundings matter; see kFarthestDark.
    const bool may_darken = is_opaque && radius > kSmallestDark && radius > distance / kFarthestDark;
    const double until_tangent = std::sqrt(distance * distance - square);
    const double half_diagonal = std::sqrt(2.0) / buffer_.cube_.side() * (1.0 + 4.0 * CubeCells::kRoom);
    for (std::size_t f = 0; f < cells.size(); ++f) {
      const CubeCells::Face& face = CubeCells::kFaces[f];
      const Vec3 there(face.negative ? -way[face.axis] : way[face.axis], way[face.u], way[face.v]);
      for (int v = cells[f].v0; v <= cells[f].v1; ++v) {
        for (int u = cells[f].u0; u <= cells[f].u1; ++u) {
          // The distance is that of the ray through the cell's middle; of those through its corners it differs by at
          // most `spread`.
          const Vec3 middle(1.0, buffer_.cube_.middle(u), buffer_.cube_.middle(v));
          const double length = middle.length();
          const double spread = distance * half_diagonal / (length - half_diagonal);
          const double passes = middle.cross(there).length() / length;
          const bool towards = middle.dot(there) > 0.0;
          const double least = towards ? std::max(passes - spread, 0.0) : 0.0;
          if (least > radius * kFarther) continue;
          const double meets = std::sqrt(std::max(distance * distance - least * least, 0.0)) -
                               std::sqrt(std::max(square - least * least, 0.0));
          seen.first = static_cast<float>(meets * kNearer);
          const bool is_dark = may_darken && towards && passes + spread < radius * kCovered;
          seen.dark = is_dark ? static_cast<float>((until_tangent + 2.0 * kShadowGap) * kFarther) : FloatBox::kInfinity;
          if (!see(f, u, v, seen)) return false;
        }
      }
    }
    return true;
  }

  bool see(std::size_t face, int u, int v, const Seen& seen) {
    const auto along = static_cast<std::size_t>(u);
    const auto across = static_cast<std::size_t>(v);
    std::uint32_t& tile =
        buffer_.tiles_[first_tile_ + (face * buffer_.tiles_along() + across / kTile) * buffer_.tiles_along() +
                       along / kTile];
    if (tile == 0) {
      buffer_.cells_.resize(buffer_.cells_.size() + kCellsOfTile);
      tile = static_cast<std::uint32_t>(buffer_.cells_.size() / kCellsOfTile);
      if (tile > kMostOpenTiles) return false;
    }
    Cell& cell = buffer_.cells_[(tile - 1) * kCellsOfTile + across % kTile * kTile + along % kTile];
    if (seen.first < cell.first) {
      cell.second = cell.first;
      cell.first = seen.first;
      cell.sphere = seen.sphere;
    } else {
      cell.second = std::min(cell.second, seen.first);
    }
    cell.dark = std::min(cell.dark, seen.dark);
    return true;
  }

  static constexpr double kSmallestDark = 1e-3;
  static constexpr double kCovered = 0.99;  ///< share of a radius

  LightBuffer& buffer_;
  const Leaves& leaves_;
  Vec3 light_;
  Around* around_ = nullptr;
  std::size_t first_tile_ = 0;
  std::size_t marks_ = 0;
};

LightBuffer::LightBuffer(const Leaves& leaves, std::span<const Light> lights) {
  if (std::ranges::none_of(lights, is_one_point) || !all_have_bounds(leaves)) return;
  around_.resize(lights.size());
  for (int side = side_for(leaves, lights); side >= kFewestCells; side /= 2) {
    cube_ = CubeCells(side);
    if (lights.size() * tiles_of_cube() > kMostTiles) continue;
    tiles_.assign(lights.size() * tiles_of_cube(), 0);
    Builder builder(*this, leaves);
    std::size_t l = 0;
    while (l < lights.size() && !Interrupt::asked() &&
           (!is_one_point(lights[l]) || builder.mark_cube(l, lights[l].position))) {
      ++l;
    }
    if (l == lights.size()) {
      mark_open_tiles();
      keep_spheres(leaves);
      return;
    }
    cells_.clear();
  }
  tiles_.clear();
}

int LightBuffer::side_for(const Leaves& leaves, std::span<const Light> lights) {
  const std::size_t things = leaves.spheres.size() + leaves.boxes.size() + leaves.solids.size();
  const std::size_t most = std::min(kMostMarks, kFewMarks + kMarksOfOne * things * lights.size());
  int side = kMostCells;
  cube_ = CubeCells(side);
  Builder builder(*this, leaves);
  // A cube of half as many cells along an edge takes a quarter of the marks; of more than 64 times as many as there may
  // be, it does not matter how many they are.
  const std::size_t far_too_many = 64 * most;
  std::size_t marks = 0;
  for (const Light& light : lights) {
    if (Interrupt::asked()) break;
    if (!is_one_point(light)) continue;
    marks += builder.measure(light.position, far_too_many - std::min(marks, far_too_many));
  }
  for (; side > kFewestCells && marks > most; marks /= 4) side /= 2;
  return side;
}

void LightBuffer::mark_open_tiles() {
  open_tiles_.resize((tiles_.size() + 31) / 32);
  for (std::size_t t = 0; t < tiles_.size(); ++t) {
    open_tiles_[t / 32] |= static_cast<std::uint32_t>(tiles_[t] != 0) << t % 32;
  }
}

// Most are behind others from every light.
void LightBuffer::keep_spheres(const Leaves& leaves) {
  std::vector<std::uint32_t> kept(leaves.sphere_blocks.size() * kLanes, kNoIndex);
  for (Cell& cell : cells_) {
    if (cell.sphere == kNoIndex) continue;
    std::uint32_t& place = kept[cell.sphere];
    if (place == kNoIndex) {
      const SphereBlock& block = leaves.sphere_blocks[cell.sphere / kLanes];
      const std::size_t lane = cell.sphere % kLanes;
      place = static_cast<std::uint32_t>(spheres_.size());
      spheres_.push_back({center_of(block, lane), block.radius_squared[lane]});
    }
    cell.sphere = place;
  }
}

}  // namespace firstlight::render
