#include "render/shape/bicubic_patch.h"

#include "render/math/interrupt.h"
#include "render/math/ray_tree.h"
#include "render/math/transform.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

using Points = BicubicPatchParameters::Points;

constexpr double kNearest = 1e-5;  ///< POV-Ray's for this shape
/// No patch is cut more often either way: a side is then a millionth as long.
constexpr int kMostSteps = 20;
/// Up to so many halvings each way the pieces are made beforehand; where that is not enough, the rest when a ray comes.
constexpr int kMostStepsBefore = 6;
constexpr std::size_t kMostInLeaf = 1;  ///< pieces are met one by one

Vec3 half(const Vec3& a, const Vec3& b) { return (a + b) * 0.5; }

/// A part of a patch, with its part of the unit square.
struct Piece {
  Points points;
  double u0 = 0.0, u1 = 1.0, v0 = 0.0, v1 = 1.0;
  int depth = 0;  ///< how often it was halved each way, if there are so many steps

  /// The lower half along u, which the first index goes by; this becomes the upper.
  Piece take_left() {
    Piece left = *this;
    left.u1 = u0 = 0.5 * (u0 + u1);
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
    bottom.v1 = v0 = 0.5 * (v0 + v1);
    for (std::size_t i = 0; i < 4; ++i) {
      split({points[i][0], points[i][1], points[i][2], points[i][3]},
            [&](std::size_t k, const Vec3& low, const Vec3& high) {
              bottom.points[i][k] = low;
              points[i][k] = high;
            });
    }
    return bottom;
  }
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

/// Where a ray meets one of the two triangles of a piece: shares of the corners but the first.
struct TriangleHit {
  double depth;
  double a;
  double b;
};

bool meet_triangle(const Ray& ray, const Vec3& p0, const Vec3& p1, const Vec3& p2, TriangleHit& hit) {
  const Vec3 b0 = p1 - p0;
  const Vec3 b1 = p2 - p0;
  Vec3 b2 = b0.cross(b1);
  const double square = b2.length2();
  if (square <= kEpsilon * b1.length2() * b0.length2()) return false;
  b2 = b2 * (1.0 / std::sqrt(square));
  const double determinant = b0.dot(b1.cross(b2));
  if (std::abs(determinant) < kEpsilon) return false;
  const Vec3 across = b0.cross(b1) / determinant;
  const double approach = ray.direction.dot(across);
  if (std::abs(approach) < kEpsilon) return false;
  hit.depth = (p0 - ray.origin).dot(across) / approach;
  if (hit.depth < kNearest) return false;
  const Vec3 q = ray.at(hit.depth) - p0;
  hit.a = q.dot(b1.cross(b2)) / determinant;
  hit.b = q.dot(b2.cross(b0)) / determinant;
  return hit.a >= 0.0 && hit.b >= 0.0 && hit.a + hit.b <= 1.0;
}

/// The normal of the whole patch, of unit length.
Vec3 normal_at(const Points& points, double u, double v) {
  struct Basis {
    std::array<double, 4> value;
    std::array<double, 4> slope;

    explicit Basis(double t) {
      const double s = 1.0 - t;
      value = {s * s * s, 3.0 * t * s * s, 3.0 * t * t * s, t * t * t};
      slope = {-3.0 * s * s, 3.0 * (s * s - 2.0 * t * s), 3.0 * (2.0 * t * s - t * t), 3.0 * t * t};
    }
  };
  const Basis along_u(u);
  const Basis along_v(v);
  Vec3 du(0.0);
  Vec3 dv(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      du += points[i][j] * (along_u.slope[i] * along_v.value[j]);
      dv += points[i][j] * (along_u.value[i] * along_v.slope[j]);
    }
  }
  const Vec3 normal = du.cross(dv);
  if (!(normal.length2() > kEpsilon * du.length2() * dv.length2())) return Vec3(1.0, 0.0, 0.0);
  return normal.normalized();
}

/// A patch in world space: how finely it is cut depends on its size there. It has no inside.
class BicubicPatch final : public Shape {
 public:
  explicit BicubicPatch(const BicubicPatchParameters& parameters) : parameters_(parameters) {
    parameters_.u_steps = std::min(parameters_.u_steps, kMostSteps);
    parameters_.v_steps = std::min(parameters_.v_steps, kMostSteps);
    std::vector<Box3> boxes;
    std::vector<Box3> unfinished_boxes;
    for_each_leaf(
        whole(), kMostStepsBefore, [](const Piece&) { return true; },
        [&](const Piece& piece) {
          if (is_leaf(piece)) {
            const Leaf& leaf = leaves_.emplace_back(piece);
            Box3& box = boxes.emplace_back();
            for (const Vec3& corner : leaf.corners) box.extendBy(corner);
          } else {
            unfinished_.push_back(piece);
            unfinished_boxes.push_back(piece.box());
          }
        });
    boxes.insert(boxes.end(), unfinished_boxes.begin(), unfinished_boxes.end());
    tree_ = RayTree(boxes, kMostInLeaf);
  }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override { meet(ray, kBoundless, out); }
  void nearest(const Ray& ray, double, double high, std::vector<Crossing>& out) const override { meet(ray, high, out); }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    Column<double> boundless;
    boundless.at.fill(kBoundless);
    std::vector<RayTree::Found>& found = found_of_thread();
    tree_.find(rays, who, nearest_only ? nearest_only->high : boundless, found);
    std::ranges::stable_sort(found, {}, &RayTree::Found::ray);
    thread_local std::vector<Crossing> list;
    SlotLists lists(*this, slots, true);
    for (auto next = found.begin(); next != found.end();) {
      const std::size_t i = next->ray;
      const Ray ray = rays.ray(i);
      list.clear();
      for (; next != found.end() && next->ray == i; ++next) meet(next->box, ray, list);
      for (const Crossing& crossing : list) lists.add(i, crossing.depth, crossing.face, crossing.place);
      if (slots.overflowed()) return;
    }
  }
  bool is_over_lanes() const override { return true; }
  bool inside(const Vec3&) const override { return false; }
  /// Interpolated between those of the corners of the triangle that was met.
  Vec3 normal(const Vec3&, const Crossing& crossing) const override {
    const auto [u, v] = crossing.place;
    const std::size_t place = crossing.face / 2;
    const Leaf piece = place < leaves_.size() ? leaves_[place] : Leaf(leaf_at(u, v));
    const double along_u = (u - piece.u0) / (piece.u1 - piece.u0);
    const double along_v = (v - piece.v0) / (piece.v1 - piece.v0);
    const auto at = [&](double pu, double pv) { return normal_at(parameters_.points, pu, pv); };
    const Vec3 first = at(piece.u0, piece.v0);
    const Vec3 last = at(piece.u1, piece.v1);
    Vec3 n;
    if (crossing.face % 2 == 0) {
      n = first * (1.0 - along_v) + at(piece.u0, piece.v1) * (along_v - along_u) + last * along_u;
    } else {
      n = first * (1.0 - along_u) + last * along_v + at(piece.u1, piece.v0) * (along_u - along_v);
    }
    return n.length2() > kEpsilon ? n.normalized() : Vec3(1.0, 0.0, 0.0);
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
  struct Leaf {
    std::array<Vec3, 4> corners;  ///< at (u0, v0), (u0, v1), (u1, v1), (u1, v0)
    double u0, u1, v0, v1;

    explicit Leaf(const Piece& piece)
        : corners{piece.points[0][0], piece.points[0][3], piece.points[3][3], piece.points[3][0]},
          u0(piece.u0),
          u1(piece.u1),
          v0(piece.v0),
          v1(piece.v1) {}
  };

  Piece whole() const { return {parameters_.points}; }
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
        if (u < left.u1) piece = left;
      }
      if (depth < parameters_.v_steps) {
        const Piece bottom = piece.take_bottom();
        if (v < bottom.v1) piece = bottom;
      }
    }
    return piece;
  }
  static std::vector<RayTree::Found>& found_of_thread() {
    thread_local std::vector<RayTree::Found> found;
    found.clear();
    return found;
  }
  void meet(const Ray& ray, double high, std::vector<Crossing>& out) const {
    std::vector<RayTree::Found>& found = found_of_thread();
    tree_.find(ray, high, found);
    for (const auto& [number, place] : found) meet(place, ray, out);
  }
  /// Meets the leaf or the unfinished piece at a place of the tree.
  void meet(std::uint32_t place, const Ray& ray, std::vector<Crossing>& out) const {
    if (place < leaves_.size()) return meet(leaves_[place], 2 * place, ray, out);
    const auto is_near = [&](const Piece& piece) { return meets(ray, padded(piece.box(), 1e-9, 1e-12)); };
    for_each_leaf(unfinished_[place - leaves_.size()], kMostSteps, is_near,
                  [&](const Piece& piece) { meet(Leaf(piece), 2 * place, ray, out); });
  }
  void meet(const Leaf& leaf, std::uint32_t face, const Ray& ray, std::vector<Crossing>& out) const {
    const double du = leaf.u1 - leaf.u0;
    const double dv = leaf.v1 - leaf.v0;
    TriangleHit hit;
    if (meet_triangle(ray, leaf.corners[0], leaf.corners[1], leaf.corners[2], hit)) {
      out.push_back({hit.depth, this, 0, face, {leaf.u0 + hit.b * du, leaf.v0 + (hit.a + hit.b) * dv}});
    }
    if (meet_triangle(ray, leaf.corners[0], leaf.corners[2], leaf.corners[3], hit)) {
      out.push_back({hit.depth, this, 0, face + 1, {leaf.u0 + (hit.a + hit.b) * du, leaf.v0 + hit.a * dv}});
    }
  }

  BicubicPatchParameters parameters_;
  std::vector<Leaf> leaves_;
  std::vector<Piece> unfinished_;
  RayTree tree_;  ///< over the leaves, then the unfinished pieces
};

}  // namespace

ShapePtr make_bicubic_patch(const BicubicPatchParameters& parameters) {
  return std::make_shared<BicubicPatch>(parameters);
}

}  // namespace firstlight::render
