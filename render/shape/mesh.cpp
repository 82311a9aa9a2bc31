#include "render/shape/mesh.h"

#include "render/math/dominant_axis.h"
#include "render/math/ray_tree.h"
#include "render/math/transform.h"
#include "render/shape/placed.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace firstlight::render {
namespace {

using Corners = MeshParameters::Corners;

/// Rays ask this of a face. Single precision is POV-Ray's.
struct Face {
  Corners corners;
  Imath::V3f normal;
  float offset;       ///< normal . p + offset = 0
  std::uint8_t u, v;  ///< the axes of the projection in which the outline is tested
  bool swapped;       ///< the first two corners are exchanged
};

/// The faces and what is said about them, in the mesh's own space.
class Faces {
 public:
  explicit Faces(MeshParameters parameters) : parameters_(std::move(parameters)) {
    std::vector<Box3> boxes;
    faces_.reserve(parameters_.faces.size());
    for (const Corners& corners : parameters_.faces) {
      const Face& face = faces_.emplace_back(prepared(corners));
      Box3 box;
      for (const std::uint32_t corner : face.corners) box.extendBy(vertex(corner));
      if (face.normal != Imath::V3f(0.0f)) bounds_.extendBy(box);
      boxes.push_back(box);
    }
    tree_ = RayTree(boxes);
  }

  const MeshParameters& parameters() const { return parameters_; }
  const Box3& bounds() const { return bounds_; }

  /// Calls visit(depth, face) for all faces that a ray with a direction of unit length meets up to `high`.
  template <class Visit>
  void meet(const Ray& ray, const double& high, const Visit& visit) const {
    tree_.walk(ray, high, [&](std::uint32_t index) {
      const double depth = meet(ray, faces_[index]);
      if (depth > 0.0 && depth <= high) visit(depth, index);
    });
  }

  Vec3 flat_normal(std::uint32_t index) const { return Vec3(faces_[index].normal); }
  Vec3 normal(const Vec3& point, std::uint32_t index) const {
    const Face& face = faces_[index];
    if (parameters_.face_normals.empty() || parameters_.face_normals[index] == MeshParameters::kNoCorners) {
      return Vec3(face.normal);
    }
    return smooth_normal(point, face, ordered(parameters_.face_normals[index], face));
  }

  Vec2 uv(const Vec3& point, std::uint32_t index) const {
    if (parameters_.face_uvs.empty()) return Vec2(0.0);
    const Corners& uvs = parameters_.face_uvs[index];
    const std::array<double, 3> weights = barycentric(point, parameters_.faces[index]);
    Vec2 uv(0.0);
    for (std::size_t i = 0; i < 3; ++i) uv += parameters_.uv[uvs[i]] * weights[i];
    return uv;
  }

  bool has_textures() const { return !parameters_.face_textures.empty(); }
  /// At `place` of some places. `point()` is asked where the corners have different textures. Pre: has_textures().
  template <class Point>
  void textures(std::uint32_t place, const Point& point, std::uint32_t index, std::vector<TextureShare>& out) const {
    const Corners& corners = parameters_.face_textures[index];
    if (corners == MeshParameters::kNoCorners) {
      out.push_back({place, kObjectTexture, 1.0});
    } else if (corners[0] == corners[1] && corners[0] == corners[2]) {
      out.push_back({place, corners[0], 1.0});
    } else {
      const std::array<double, 3> weights = barycentric(point(), parameters_.faces[index]);
      const double sum = weights[0] + weights[1] + weights[2];
      for (std::size_t i = 0; i < 3; ++i) out.push_back({place, corners[i], weights[i] / sum});
    }
  }

 private:
  Vec3 vertex(std::uint32_t index) const { return Vec3(parameters_.vertices[index]); }

  static Corners ordered(Corners corners, const Face& face) {
    if (face.swapped) std::swap(corners[0], corners[1]);
    return corners;
  }

  Face prepared(const Corners& corners) const {
    Face face{corners, Imath::V3f(0.0f), 0.0f, 0, 1, false};
    const Vec3 a = vertex(corners[0]);
    const Vec3 b = vertex(corners[1]);
    const Vec3 c = vertex(corners[2]);
    Vec3 normal = (c - a).cross(b - a);
    const double length = normal.length();
    if (!(length > 0.0) || !std::isfinite(length)) return face;
    normal /= length;
    face.normal = Imath::V3f(normal);
    face.offset = static_cast<float>(-normal.dot(a));
    const int axis = dominant_axis(normal);
    face.u = axis == 0 ? 1 : 0;
    face.v = axis == 2 ? 1 : 2;
    face.swapped =
        (b[face.u] - c[face.u]) * (b[face.v] - a[face.v]) < (b[face.v] - c[face.v]) * (b[face.u] - a[face.u]);
    face.corners = ordered(corners, face);
    return face;
  }

  /// The depth of the crossing, or a negative number. Points on an edge are in. [POV-Ray 3.7]
  double meet(const Ray& ray, const Face& face) const {
    const Vec3 normal(face.normal);
    const double approach = normal.dot(ray.direction);
    if (!(std::abs(approach) >= kEpsilon)) return -1.0;
    const double depth = -(static_cast<double>(face.offset) + normal.dot(ray.origin)) / approach;
    if (!(depth >= kNearestCrossing && depth <= kMaxDistance)) return -1.0;
    const double u = ray.origin[face.u] + depth * ray.direction[face.u];
    const double v = ray.origin[face.v] + depth * ray.direction[face.v];
    const Vec3 corner[3] = {vertex(face.corners[0]), vertex(face.corners[1]), vertex(face.corners[2])};
    const auto is_outside = [&](const Vec3& from, const Vec3& to) {
      return (to[face.u] - u) * (to[face.v] - from[face.v]) < (to[face.v] - v) * (to[face.u] - from[face.u]);
    };
    const bool outside =
        is_outside(corner[0], corner[1]) || is_outside(corner[1], corner[2]) || is_outside(corner[2], corner[0]);
    return outside ? -1.0 : depth;
  }

  /// A line from the first corner through the point meets the opposite edge at `v` of its length; the point lies at `u`
  /// of the way there. [POV-Ray 3.7]
  Vec3 smooth_normal(const Vec3& point, const Face& face, const Corners& normals) const {
    const Vec3 a = vertex(face.corners[0]);
    const Vec3 b = vertex(face.corners[1]);
    const Vec3 c = vertex(face.corners[2]);
    const Vec3 na(parameters_.normals[normals[0]]);
    const Vec3 nb(parameters_.normals[normals[1]]);
    const Vec3 nc(parameters_.normals[normals[2]]);
    const int axis = dominant_axis(c - b);
    const Vec3 along = (b - c).normalized();
    const Vec3 from_c = a - c;
    const Vec3 across = (along * from_c.dot(along) - from_c).normalized();
    const Vec3 to_edge = across / -from_c.dot(across);
    const Vec3 from_a = point - a;
    const double u = from_a.dot(to_edge);
    if (u < kEpsilon) return na;
    const double v = (from_a[axis] / u + a[axis] - b[axis]) / (c[axis] - b[axis]);
    return na + (nb - na + (nc - nb) * v) * u;
  }

  /// How near the point is to each corner: 1 there, 0 on the opposite edge.
  std::array<double, 3> barycentric(const Vec3& point, const Corners& corners) const {
    std::array<double, 3> weights;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 here = vertex(corners[i]);
      const Vec3 to_last = vertex(corners[(i + 2) % 3]) - here;
      const Vec3 edge = vertex(corners[(i + 2) % 3]) - vertex(corners[(i + 1) % 3]);
      const Vec3 height = edge * (to_last.dot(edge) / edge.dot(edge)) - to_last;
      weights[i] = 1.0 + (point - here).dot(height) / height.dot(height);
    }
    return weights;
  }

  MeshParameters parameters_;
  std::vector<Face> faces_;
  RayTree tree_;
  Box3 bounds_;
};

/// A mesh where it stands.
class Mesh final : public Shape {
 public:
  Mesh(std::shared_ptr<const Faces> faces, Transform transform, bool inverted)
      : faces_(std::move(faces)), transform_(std::move(transform)), inverted_(inverted) {}

  const MeshParameters& parameters() const { return faces_->parameters(); }
  const Faces& faces() const { return *faces_; }
  const Transform& placement() const { return transform_; }

  void crossings(const Ray& given, std::vector<Crossing>& out) const override {
    const UnitRay unit_ray(transform_.inverse_ray(given));
    const double length = unit_ray.length;
    const Ray& ray = unit_ray.ray;
    faces_->meet(ray, kMaxDistance, [&](double depth, std::uint32_t face) {
      out.push_back({depth / length, this, 0, face, {}});
    });
  }
  void nearest(const Ray& given, double low, double high, std::vector<Crossing>& out) const override {
    const UnitRay unit_ray(transform_.inverse_ray(given));
    const double length = unit_ray.length;
    const Ray& ray = unit_ray.ray;
    double limit = std::min(kMaxDistance, high * length * (1.0 + kRoom));
    faces_->meet(ray, limit, [&](double depth, std::uint32_t face) {
      if (!(depth / length > low)) return;
      out.push_back({depth / length, this, 0, face, {}});
      limit = std::min(limit, depth);
    });
  }
  /// The ray that counts surfaces keeps its direction in space when the mesh is turned. [POV-Ray 3.7]
  bool inside(const Vec3& point) const override {
    if (!faces_->parameters().inside_vector) return false;
    bool odd = false;
    faces_->meet(UnitRay(transform_.inverse_ray({point, *faces_->parameters().inside_vector})).ray, kMaxDistance,
                 [&](double, std::uint32_t) { odd = !odd; });
    return odd != inverted_;
  }
  Vec3 normal(const Vec3& point, const Crossing& crossing) const override {
    const Vec3 own = faces_->normal(transform_.inverse_point(point), crossing.face);
    const Vec3 n = transform_.normal(own).normalized();
    return inverted_ ? -n : n;
  }
  void normals(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns3<double>& out) const override {
    for (std::size_t i = first; i < end; ++i) out.set(i, Mesh::normal(places.point.vector(i), *places.crossing[i]));
  }
  Vec2 uv(const Vec3& point, const Crossing& crossing) const override {
    return faces_->uv(transform_.inverse_point(point), crossing.face);
  }
  void uvs(const SurfacePlaces& places, std::size_t first, std::size_t end, Columns2<double>& out) const override {
    for (std::size_t i = first; i < end; ++i) out.set(i, Mesh::uv(places.point.vector(i), *places.crossing[i]));
  }
  void textures(const SurfacePlaces& places, std::size_t first, std::size_t end,
                std::vector<TextureShare>& out) const override {
    if (!faces_->has_textures()) return Shape::textures(places, first, end, out);
    for (std::size_t i = first; i < end; ++i) {
      const auto point = [&] { return transform_.inverse_point(places.point.vector(i)); };
      faces_->textures(static_cast<std::uint32_t>(i), point, places.crossing[i]->face, out);
    }
  }
  Box3 bounds() const override { return transform_.box(faces_->bounds()); }
  Box3 inside_bounds() const override {
    return inverted_ && faces_->parameters().inside_vector ? boundless_box() : bounds();
  }
  Box3 outside_bounds() const override {
    return inverted_ && faces_->parameters().inside_vector ? bounds() : boundless_box();
  }
  ShapePtr placed(const Transform& transform) const override {
    return std::make_shared<Mesh>(faces_, transform_.then(transform), inverted_);
  }
  ShapePtr inverted() const override { return std::make_shared<Mesh>(faces_, transform_, !inverted_); }

 private:
  /// Rounding of depths there and back.
  static constexpr double kRoom = 1e-12;

  std::shared_ptr<const Faces> faces_;
  Transform transform_;
  bool inverted_;
};

}  // namespace

ShapePtr make_mesh(MeshParameters parameters) {
  return std::make_shared<Mesh>(std::make_shared<const Faces>(std::move(parameters)), Transform(), false);
}

const MeshParameters* mesh_of(const Shape& shape) {
  const auto* mesh = dynamic_cast<const Mesh*>(&shape);
  return mesh == nullptr ? nullptr : &mesh->parameters();
}

const Transform& mesh_placement(const Shape& mesh) { return dynamic_cast<const Mesh&>(mesh).placement(); }

Vec3 flat_normal(const Shape& mesh, std::uint32_t face) {
  return dynamic_cast<const Mesh&>(mesh).faces().flat_normal(face);
}

Vec3 smooth_normal(const Shape& mesh, const Vec3& point, std::uint32_t face) {
  return dynamic_cast<const Mesh&>(mesh).faces().normal(point, face);
}

}  // namespace firstlight::render
