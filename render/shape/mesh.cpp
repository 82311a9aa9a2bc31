#include "render/shape/mesh.h"

#include "render/math/transform.h"
#include "render/shape/mesh_faces.h"
#include "render/shape/slots.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

/// A mesh where it stands.
class Mesh final : public Shape {
 public:
  Mesh(std::shared_ptr<const MeshFaces> faces, Transform transform, bool inverted)
      : faces_(std::move(faces)), transform_(std::move(transform)), inverted_(inverted) {}

  const MeshParameters& parameters() const { return faces_->parameters(); }
  const MeshFaces& faces() const { return *faces_; }
  const Transform& placement() const { return transform_; }

  void crossings(const Ray& ray, std::vector<Crossing>& out) const override {
    for (const FaceMet& met : all_met(transform_.inverse_ray(ray))) out.push_back({met.depth, this, 0, met.face, {}});
  }
  void nearest(const Ray& ray, double low, double high, std::vector<Crossing>& out) const override {
    const RayColumns rays = alone(ray);
    const Column<double> lows = alone(low), highs = alone(high);
    const DepthWindow window{lows, highs};
    Column<double> depth, face;
    if (faces_->meet_nearest({*this, transform_, rays, 1, &window}, depth, face) == 0) return;
    out.push_back({depth[0], this, 0, static_cast<std::uint32_t>(face[0]), {}});
  }
  void meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only,
                  Slots& slots) const override {
    if (nearest_only == nullptr) return Shape::meet_block(rays, who, nearest_only, slots);
    Slot* slot = slots.add(*this);
    if (slot == nullptr) return;
    slot->has_faces = true;
    slot->rays =
        faces_->meet_nearest({*this, transform_, rays, who, nearest_only}, slot->depth, slot->own_details().face);
    slots.drop_empty(slots.size() - 1);
  }
  bool is_over_lanes() const override { return true; }
  /// The ray that counts surfaces keeps its direction in space when the mesh is turned. [POV-Ray 3.7]
  bool inside(const Vec3& point) const override {
    if (!faces_->parameters().inside_vector) return false;
    const Ray ray = transform_.inverse_ray({point, *faces_->parameters().inside_vector});
    return (all_met(ray).size() % 2 != 0) != inverted_;
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
  /// Pre: the ray is in the mesh's own space.
  std::span<const FaceMet> all_met(const Ray& ray) const {
    thread_local std::vector<FaceMet> met;
    met.clear();
    faces_->meet(ray, met);
    return met;
  }

  std::shared_ptr<const MeshFaces> faces_;
  Transform transform_;
  bool inverted_;
};

}  // namespace

ShapePtr make_mesh(MeshParameters parameters) {
  return std::make_shared<Mesh>(std::make_shared<const MeshFaces>(std::move(parameters)), Transform(), false);
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
