#include "render/shape/bicubic_patch.h"

#include "render/math/interrupt.h"
#include "render/math/ray_tree.h"
#include "render/math/transform.h"
#include "render/shape/patch_faces.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/bicubic_patch.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"
#include "render/lanes/length-inl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#ifndef FIRSTLIGHT_RENDER_SHAPE_BICUBIC_PATCH
#define FIRSTLIGHT_RENDER_SHAPE_BICUBIC_PATCH
namespace firstlight::render {
namespace {

/// A part of the unit square.
struct Square {
  double u0 = 0.0, u1 = 1.0, v0 = 0.0, v1 = 1.0;
};

/// Places on a patch, each in one of the two triangles of a piece.
struct PatchPlaces {
  Column<double> u, v;
  Column<double> u0, u1, v0, v1;  ///< the piece's square
  Column<double> is_second;       ///< 1 in the triangle with the corner (u1, v0), 0 in that with (u0, v1)
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Bernstein's polynomials of order 3, and their derivatives.
template <class L>
struct CubicBasis {
  L value[4];
  L slope[4];
};

template <class L>
HWY_INLINE CubicBasis<L> cubic_basis(const L& t) {
  const L s = 1.0 - t;
  return {{s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t},
          {-3.0 * s * s, 3.0 * (s * s - 2.0 * t * s), 3.0 * (2.0 * t * s - t * t), 3.0 * t * t}};
}

/// The normal of the whole patch, of unit length.
template <class L>
HWY_INLINE Vec3Of<L> normal_at(const BicubicPatchParameters::Points& points, const L& u, const L& v) {
  const CubicBasis<L> along_u = cubic_basis(u), along_v = cubic_basis(v);
  Vec3Of<L> du{0.0, 0.0, 0.0}, dv{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto point = everywhere<L>(points[i][j]);
      du = du + point * (along_u.slope[i] * along_v.value[j]);
      dv = dv + point * (along_u.value[i] * along_v.slope[j]);
    }
  }
  const Vec3Of<L> normal = cross(du, dv);
  const auto counts = dot(normal, normal) > kEpsilon * dot(du, du) * dot(dv, dv);
  return select<L>(counts, normalized(normal), {1.0, 0.0, 0.0});
}

/// Interpolated between those of the corners of the triangle that was met.
template <class L>
HWY_INLINE Vec3Of<L> interpolated_normal(const BicubicPatchParameters::Points& points, const PatchPlaces& places,
                                         std::size_t i) {
  const L u0 = load<L>(places.u0, i), u1 = load<L>(places.u1, i);
  const L v0 = load<L>(places.v0, i), v1 = load<L>(places.v1, i);
  const L along_u = (load<L>(places.u, i) - u0) / (u1 - u0);
  const L along_v = (load<L>(places.v, i) - v0) / (v1 - v0);
  const auto is_second = load<L>(places.is_second, i) != 0.0;
  const Vec3Of<L> first = normal_at(points, u0, v0), last = normal_at(points, u1, v1);
  const Vec3Of<L> between = normal_at(points, select(is_second, u1, u0), select(is_second, v0, v1));
  const Vec3Of<L> n = first * select(is_second, 1.0 - along_u, 1.0 - along_v) +
                      select<L>(is_second, last, between) * select(is_second, along_v, along_v - along_u) +
                      select<L>(is_second, between, last) * select(is_second, along_u - along_v, along_u);
  return select<L>(dot(n, n) > kEpsilon, normalized(n), {1.0, 0.0, 0.0});
}

void find_patch_normals(const BicubicPatchParameters::Points& points, const PatchPlaces& places, std::size_t count,
                        Columns3<double>& normals) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    store3(interpolated_normal<Lanes>(points, places, i), normals, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_patch_normals);

namespace {

using Points = BicubicPatchParameters::Points;

/// No patch is cut more often either way: a side is then a millionth as long.
constexpr int kMostSteps = 20;
/// Up to so many halvings each way the pieces are made beforehand; where that is not enough, the rest when a ray comes.
constexpr int kMostStepsBefore = 6;
constexpr std::size_t kMostInLeaf = 1;  ///< pieces that are finished when a ray comes are met one by one

Vec3 half(const Vec3& a, const Vec3& b) { return (a + b) * 0.5; }

/// A part of a patch, with its part of the unit square.
struct Piece {
  Points points;
  Square square;
  int depth = 0;  ///< how often it was halved each way, if there are so many steps

  /// The lower half along u, which the first index goes by; this becomes the upper.
  Piece take_left() {
    Piece left = *this;
    left.square.u1 = square.u0 = 0.5 * (square.u0 + square.u1);
    for (std::size_t i = 0; i < 4; ++i) {
      split({points[0][i], points[1][i], points[2][i], points[3][i]},
            [&](std::size_t k, const Vec3& low, const Vec3& high) {
              left.points[k][i] = low;
              points[k][i] = high;
            });
    }
    return left;
  }
  Piece take_bottom() {
    Piece bottom = *this;
    bottom.square.v1 = square.v0 = 0.5 * (square.v0 + square.v1);
    for (std::size_t i = 0; i < 4; ++i) {
      split({points[i][0], points[i][1], points[i][2], points[i][3]},
            [&](std::size_t k, const Vec3& low, const Vec3& high) {
              bottom.points[i][k] = low;
              points[i][k] = high;
            });
    }
    return bottom;
  }
  PatchFaces::Corners corners() const { return {points[0][0], points[0][3], points[3][3], points[3][0]}; }
  Box3 box() const {
    Box3 box;
    for (const auto& row : points) {
      for (const Vec3& point : row) box.extendBy(point);
    }
    return box;
  }
  /// How far the points are from the plane of three corners; negative where these are on one line. [POV-Ray 3.7]
  double bend() const {
    const Vec3& first = points[0][0];
    Vec3 second = points[0][3];
    if ((first - second).length() < kEpsilon) second = points[3][3];
    if ((first - second).length() < kEpsilon) return -1.0;
    const Vec3& third = points[3][0];
    if ((second - third).length() < kEpsilon) return -1.0;
    const Vec3 a = first - second;
    const Vec3 b = third - second;
    Vec3 normal = a.cross(b);
    if (normal.length2() <= kEpsilon * a.length2() * b.length2()) return -1.0;
    normal.normalize();
    double farthest = 0.0;
    for (const auto& row : points) {
      for (const Vec3& point : row) farthest = std::max(farthest, std::abs((point - first).dot(normal)));
    }
    return farthest;
  }

 private:
  /// De Casteljau's halving of a curve.
  template <class Take>
  static void split(const std::array<Vec3, 4>& p, const Take& take) {
    const Vec3 a = half(p[0], p[1]);
    const Vec3 middle = half(p[1], p[2]);
    const Vec3 b = half(a, middle);
    const Vec3 f = half(p[2], p[3]);
    const Vec3 e = half(middle, f);
    const Vec3 d = half(b, e);
    take(0, p[0], d);
    take(1, a, e);
    take(2, b, f);
    take(3, d, p[3]);
  }
};

/// A patch in world space: how finely it is cut depends on its size there. It has no inside.
class BicubicPatch final : public Shape {
 public:
  explicit BicubicPatch(const BicubicPatchParameters& parameters) : parameters_(parameters) {
    parameters_.u_steps = std::min(parameters_.u_steps, kMostSteps);
    parameters_.v_steps = std::min(parameters_.v_steps, kMostSteps);
    std::vector<PatchFaces::Corners> corners;
    std::vector<Box3> boxes;
    for_each_leaf(
        whole(), kMostStepsBefore, [](const Piece&) { return true; },
        [&](const Piece& piece) {
          if (is_leaf(piece)) {
            squares_.push_back(piece.square);
            corners.push_back(piece.corners());
          } else {
            unfinished_.push_back(piece);
            boxes.push_back(piece.box());
          }
        });
    faces_ = PatchFaces(corners);
    unfinished_tree_ = RayTree(boxes, kMostInLeaf);
  }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override { nearest(ray, 0.0, kBoundless, out); }
  void nearest(const Ray& ray, double, double high, std::vector<Crossing>& out) const override {
    meet(alone(ray), 1, alone(high), [&](std::size_t, double depth, std::uint32_t face, const auto& place) {
      out.push_back({depth, this, 0, face, place});
    });
  }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    Column<double> boundless;
    boundless.at.fill(kBoundless);
    SlotLists lists(*this, slots, true);
    meet(rays, who, nearest_only ? nearest_only->high : boundless,
         [&](std::size_t ray, double depth, std::uint32_t face, const auto& place) {
           lists.add(ray, depth, face, place);
         });
  }
  bool is_over_lanes() const override { return true; }
  bool inside(const Vec3&) const override { return false; }
  Vec3 normal(const Vec3&, const Crossing& crossing) const override {
    PatchPlaces place;
    set(place, 0, crossing);
    const auto n = HWY_NAMESPACE::interpolated_normal<One>(parameters_.points, place, 0);
    return {n.x.v, n.y.v, n.z.v};
  }
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const override {
    PatchPlaces on_patch;
    const std::size_t count = end - first;
    for (std::size_t i = 0; i < count; ++i) set(on_patch, i, *places.crossing[first + i]);
    Columns3<double> found;
    HWY_DYNAMIC_DISPATCH(find_patch_normals)(parameters_.points, on_patch, count, found);
    for (std::size_t i = 0; i < count; ++i) out.set(first + i, found.vector(i));
  }
  Vec2 uv(const Vec3&, const Crossing& crossing) const override {
    const auto [u, v] = crossing.place;
    const auto& corner = parameters_.uv;
    const Vec2 low = corner[0] + (corner[1] - corner[0]) * v;
    const Vec2 high = corner[3] + (corner[2] - corner[3]) * v;
    return low + (high - low) * u;
  }
  Box3 bounds() const override { return whole().box(); }
  Box3 inside_bounds() const override { return bounds(); }
  ShapePtr placed(const Transform& transform) const override {
    BicubicPatchParameters moved = parameters_;
    for (auto& row : moved.points) {
      for (Vec3& point : row) point = transform.point(point);
    }
    return std::make_shared<BicubicPatch>(moved);
  }
  ShapePtr inverted() const override { return std::make_shared<BicubicPatch>(*this); }

 private:
  Piece whole() const { return {parameters_.points, {}}; }
  /// Whether a piece is not cut further.
  bool is_leaf(const Piece& piece) const {
    if (piece.depth >= parameters_.u_steps && piece.depth >= parameters_.v_steps) return true;
    const double bend = piece.bend();
    return bend >= 0.0 && bend < parameters_.flatness;
  }
  /// Visits the leaves of a piece, and pieces that were halved `deepest` times each way.
  template <class IsWanted, class Visit>
  void for_each_leaf(Piece piece, int deepest, const IsWanted& is_wanted, const Visit& visit) const {
    if (!is_wanted(piece) || Interrupt::asked()) return;
    if (piece.depth >= deepest || is_leaf(piece)) return visit(piece);
    const int depth = piece.depth++;
    const auto down = [&](Piece part) {
      if (depth < parameters_.v_steps) for_each_leaf(part.take_bottom(), deepest, is_wanted, visit);
      for_each_leaf(part, deepest, is_wanted, visit);
    };
    if (depth < parameters_.u_steps) down(piece.take_left());
    down(piece);
  }
  /// The piece that holds a place.
  Piece leaf_at(double u, double v) const {
    Piece piece = whole();
    while (!is_leaf(piece)) {
      const int depth = piece.depth++;
      if (depth < parameters_.u_steps) {
        const Piece left = piece.take_left();
        if (u < left.square.u1) piece = left;
      }
      if (depth < parameters_.v_steps) {
        const Piece bottom = piece.take_bottom();
        if (v < bottom.square.v1) piece = bottom;
      }
    }
    return piece;
  }
  static void set(PatchPlaces& places, std::size_t i, const Square& square) {
    places.u0[i] = square.u0;
    places.u1[i] = square.u1;
    places.v0[i] = square.v0;
    places.v1[i] = square.v1;
  }
  void set(PatchPlaces& places, std::size_t i, const Crossing& crossing) const {
    const auto [u, v] = crossing.place;
    const std::size_t piece = crossing.face / 2;
    places.u[i] = u;
    places.v[i] = v;
    places.is_second[i] = crossing.face % 2;
    set(places, i, piece < squares_.size() ? squares_[piece] : leaf_at(u, v).square);
  }
  /// Where in the unit square a triangle of a piece is met.
  static std::array<double, 2> place_of(const PatchFaces::Met& met, const Square& square) {
    const double du = square.u1 - square.u0;
    const double dv = square.v1 - square.v0;
    const double both = met.a + met.b;
    return met.face % 2 == 0 ? std::array{square.u0 + met.b * du, square.v0 + both * dv}
                             : std::array{square.u0 + both * du, square.v0 + met.a * dv};
  }
  /// Calls take(ray, depth, face, place) for what those rays in `who` meet.
  template <class Take>
  void meet(const RayColumns& rays, std::uint64_t who, const Column<double>& high, const Take& take) const {
    thread_local std::vector<PatchFaces::Met> met;
    met.clear();
    faces_.meet(rays, who, high, met);
    for (const PatchFaces::Met& there : met) {
      take(there.ray, there.depth, there.face, place_of(there, squares_[there.face / 2]));
    }
    if (unfinished_.empty()) return;
    thread_local std::vector<RayTree::Found> found;
    found.clear();
    unfinished_tree_.find(rays, who, high, found);
    for (const RayTree::Found& near : found) {
      const Ray ray = rays.ray(near.ray);
      const auto is_near = [&](const Piece& piece) { return meets(ray, padded(piece.box(), 1e-9, 1e-12)); };
      const auto face = static_cast<std::uint32_t>(squares_.size()) + near.box;
      for_each_leaf(unfinished_[near.box], kMostSteps, is_near, [&](const Piece& piece) {
        met.clear();
        PatchFaces::meet(piece.corners(), ray, face, met);
        for (const PatchFaces::Met& there : met) {
          take(near.ray, there.depth, there.face, place_of(there, piece.square));
        }
      });
    }
  }

  BicubicPatchParameters parameters_;
  std::vector<Square> squares_;  ///< of the pieces that are made beforehand
  PatchFaces faces_;
  std::vector<Piece> unfinished_;
  RayTree unfinished_tree_;
};

}  // namespace

ShapePtr make_bicubic_patch(const BicubicPatchParameters& parameters) {
  return std::make_shared<BicubicPatch>(parameters);
}

}  // namespace firstlight::render
#endif
