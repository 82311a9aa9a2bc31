// Cameras that sit on the faces of meshes and look along their normals. [POV-Ray 3.7 manual, "Mesh Camera"]

#include "render/camera/projection.h"
#include "render/math/ray_tree.h"
#include "render/shape/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

using Corners = MeshParameters::Corners;

/// A mesh with the faces that a camera can sit on: those that have an area, in their order.
class Seats {
 public:
  explicit Seats(ShapePtr mesh) : mesh_(std::move(mesh)), parameters_(*mesh_of(*mesh_)) {
    for (std::uint32_t face = 0; face < parameters_.faces.size(); ++face) {
      if (flat_normal(*mesh_, face) != Vec3(0.0)) faces_.push_back(face);
    }
  }

  std::size_t size() const { return faces_.size(); }
  /// The corners of the seat's face, in the mesh's own space.
  std::array<Vec3, 3> corners(std::size_t seat) const {
    const Corners& corners = parameters_.faces[faces_[seat]];
    return {vertex(corners[0]), vertex(corners[1]), vertex(corners[2])};
  }
  std::array<Vec2, 3> uv(std::size_t seat) const {
    if (parameters_.face_uvs.empty()) return {Vec2(0.0), Vec2(0.0), Vec2(0.0)};
    const Corners& corners = parameters_.face_uvs[faces_[seat]];
    return {parameters_.uv[corners[0]], parameters_.uv[corners[1]], parameters_.uv[corners[2]]};
  }
  Vec3 normal(std::size_t seat) const { return flat_normal(*mesh_, faces_[seat]); }
  Vec3 normal(std::size_t seat, const Vec3& point) const { return smooth_normal(*mesh_, point, faces_[seat]); }
  const Transform& placement() const { return mesh_placement(*mesh_); }
  Box3 bounds() const { return mesh_->bounds(); }

 private:
  Vec3 vertex(std::uint32_t index) const { return Vec3(parameters_.vertices[index]); }

  ShapePtr mesh_;
  const MeshParameters& parameters_;
  std::vector<std::uint32_t> faces_;
};

/// The face in whose part of the surface's own coordinates a place lies.
class UvFinder {
 public:
  struct Found {
    std::size_t seat;
    std::array<double, 3> weights;  ///< of the corners
  };

  explicit UvFinder(const Seats& seats) : seats_(seats) {
    constexpr double kRoom = 1e-9;  // for the rounding of single precision there is the tree's own
    std::vector<Box3> boxes;
    boxes.reserve(seats.size());
    for (std::size_t seat = 0; seat < seats.size(); ++seat) {
      Box3 box;
      for (const Vec2& uv : seats.uv(seat)) {
        box.extendBy({uv.x - kRoom, uv.y - kRoom, -1.0});
        box.extendBy({uv.x + kRoom, uv.y + kRoom, 1.0});
      }
      boxes.push_back(box);
    }
    tree_ = RayTree(boxes, kMostInLeaf);
  }

  /// The first such face.
  std::optional<Found> at(double u, double v) const {
    thread_local std::vector<RayTree::Found> near;
    near.clear();
    tree_.find(Ray{{u, v, -2.0}, {0.0, 0.0, 1.0}}, kThroughAll, near);
    std::optional<Found> first;
    for (const auto& [ray, seat] : near) {
      if (first && first->seat < seat) continue;
      const auto [a, b, c] = seats_.uv(seat);
      const auto area = [](double x1, double y1, double x2, double y2) { return x1 * y2 - x2 * y1; };
      const double whole = area(b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y);
      const std::array<double, 3> weights{area(b.x - u, b.y - v, c.x - u, c.y - v) / whole,
                                          area(c.x - u, c.y - v, a.x - u, a.y - v) / whole,
                                          area(a.x - u, a.y - v, b.x - u, b.y - v) / whole};
      if (weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0) first = Found{seat, weights};
    }
    return first;
  }

 private:
  static constexpr double kThroughAll = 4.0;
  static constexpr std::size_t kMostInLeaf = 2;

  const Seats& seats_;
  RayTree tree_;
};

class MeshProjection final : public Projection {
 public:
  explicit MeshProjection(const Camera& camera)
      : distribution_(camera.mesh.distribution),
        smooth_(camera.mesh.smooth),
        // Further rays of method 1 would come from faces behind the last.
        rays_(distribution_ == 0 ? camera.mesh.rays_per_pixel : 1),
        above_(camera.location.z),
        backwards_(camera.direction.z < -kLeast) {
    for (const ShapePtr& mesh : camera.mesh.meshes) {
      seats_.emplace_back(mesh);
      origins_.extendBy(origins_of(seats_.back()));
      if (distribution_ == 3) break;
    }
    if (distribution_ == 3 && !seats_.empty()) by_uv_.emplace(seats_.front());
  }

  Box3 origins() const override { return origins_; }
  int rays_per_place() const override { return rays_; }
  void project(const PicturePlaces& places, CameraRays& rays) const override { project_further(0, places, rays); }
  void project_further(int number, const PicturePlaces& places, CameraRays& rays) const override {
    rays.missing = 0;
    for (std::size_t i = 0; i < places.size; ++i) {
      const std::optional<Ray> ray = ray_at(places, i, static_cast<std::size_t>(number));
      if (!ray) {
        rays.missing |= std::uint64_t{1} << i;
        continue;
      }
      rays.origin.set(i, ray->origin);
      rays.direction.set(i, ray->direction);
      rays.x[i] = 0.0;
      rays.y[i] = 0.0;
    }
  }

 private:
  static constexpr double kLeast = 1e-10;  // [POV-Ray 3.7]

  std::optional<Ray> ray_at(const PicturePlaces& places, std::size_t i, std::size_t number) const {
    if (number >= seats_.size()) return std::nullopt;
    // The middle of a pixel is taken for the border above it. [POV-Ray 3.7]
    const double x = std::clamp(places.x[i], 0.0, places.width - 1.0);
    const double y = std::clamp(places.y[i] - 1.0, 0.0, std::max(places.height - 1.0, 0.0));
    if (distribution_ == 3) return ray_by_uv((x - 0.5) / places.width, 1.0 - (y + 0.5) / places.height);
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const auto width = static_cast<std::size_t>(places.width);
    if (distribution_ == 0) return ray_from(seats_[number], row * width + column);
    if (distribution_ == 2) {
      const double share = places.width / static_cast<double>(seats_.size());
      const auto mesh = std::min(static_cast<std::size_t>(x / share), seats_.size() - 1);
      return ray_from(seats_[mesh], row * (width / seats_.size()) + column);
    }
    std::size_t seat = row * width + column;
    for (const Seats& seats : seats_) {
      if (seat < seats.size()) return ray_from(seats, seat);
      seat -= seats.size();
    }
    return std::nullopt;
  }

  std::optional<Ray> ray_from(const Seats& seats, std::size_t seat) const {
    if (seat >= seats.size()) return std::nullopt;
    const auto [a, b, c] = seats.corners(seat);
    return placed(seats, (a + b + c) / 3.0, seats.normal(seat));
  }

  std::optional<Ray> ray_by_uv(double u, double v) const {
    const std::optional<UvFinder::Found> found = by_uv_->at(u, v);
    if (!found) return std::nullopt;
    const Seats& seats = seats_.front();
    const auto [a, b, c] = seats.corners(found->seat);
    const Vec3 point = a * found->weights[0] + b * found->weights[1] + c * found->weights[2];
    return placed(seats, point, smooth_ ? seats.normal(found->seat, point) : seats.normal(found->seat));
  }

  Ray placed(const Seats& seats, const Vec3& point, const Vec3& normal) const {
    const Vec3 direction = seats.placement().normal(backwards_ ? -normal : normal);
    return {seats.placement().point(point + normal * above_), direction};
  }

  /// The mesh, and room to be above or below it.
  Box3 origins_of(const Seats& seats) const {
    Box3 box = seats.bounds();
    const Mat4 none;
    const Mat4& matrix = seats.placement().is_identity() ? none : seats.placement().matrix();
    double longest = 0.0;
    for (int row = 0; row < 3; ++row) longest += Vec3(matrix[row][0], matrix[row][1], matrix[row][2]).length();
    constexpr double kSmoothNormals = 2.0;  // they need not have length 1
    const Vec3 room(kSmoothNormals * std::abs(above_) * longest);
    if (!box.isEmpty()) box = Box3(box.min - room, box.max + room);
    return box;
  }

  int distribution_;
  bool smooth_;
  int rays_;
  double above_;  ///< the faces the rays begin so high, in the mesh's own space
  bool backwards_;
  std::vector<Seats> seats_;  ///< those of the meshes, which do not move once the finder looks at them
  std::optional<UvFinder> by_uv_;
  Box3 origins_;
};

}  // namespace

ProjectionPtr projection::make_mesh_camera(const Camera& camera) { return std::make_unique<MeshProjection>(camera); }

}  // namespace firstlight::render
