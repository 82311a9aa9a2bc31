#include "render/shape/mesh_faces.h"

#include "render/math/dominant_axis.h"
#include "render/shape/tolerance.h"

#include <cmath>
#include <utility>

namespace firstlight::render {

MeshFaces::MeshFaces(MeshParameters parameters) : parameters_(std::move(parameters)) {
  std::vector<RayTree::Item> items;
  items.reserve(parameters_.faces.size());
  for (std::uint32_t index = 0; index < parameters_.faces.size(); ++index) {
    if (plane_of(index).normal == Imath::V3f(0.0f)) continue;
    Imath::Box3f box;
    for (const std::uint32_t corner : parameters_.faces[index]) box.extendBy(parameters_.vertices[corner]);
    bounds_.extendBy(Box3(Vec3(box.min), Vec3(box.max)));
    items.push_back({box, index});
  }
  tree_ = RayTree(std::move(items));
  blocks_.reserve(tree_.leaves().size());
  for (const RayTree::Leaf& leaf : tree_.leaves()) blocks_.push_back(block_of(leaf));
}

MeshFaces::Plane MeshFaces::plane_of(std::uint32_t index) const {
  const Corners& corners = parameters_.faces[index];
  Plane plane;
  const Vec3 a = vertex(corners[0]);
  const Vec3 b = vertex(corners[1]);
  const Vec3 c = vertex(corners[2]);
  Vec3 normal = (c - a).cross(b - a);
  const double length = normal.length();
  if (!(length > 0.0) || !std::isfinite(length)) return plane;
  normal /= length;
  plane.normal = Imath::V3f(normal);
  plane.offset = static_cast<float>(-normal.dot(a));
  const int axis = dominant_axis(normal);
  plane.u = axis == 0 ? 1 : 0;
  plane.v = axis == 2 ? 1 : 2;
  plane.swapped =
      (b[plane.u] - c[plane.u]) * (b[plane.v] - a[plane.v]) < (b[plane.v] - c[plane.v]) * (b[plane.u] - a[plane.u]);
  return plane;
}

MeshFaces::Block MeshFaces::block_of(const RayTree::Leaf& leaf) const {
  Block block{};
  block.face = leaf;
  for (std::size_t i = 0; i < Block::kSize && leaf[i] != RayTree::kNone; ++i) {
    const Plane plane = plane_of(leaf[i]);
    Corners corners = parameters_.faces[leaf[i]];
    if (plane.swapped) std::swap(corners[0], corners[1]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Imath::V3f& corner = parameters_.vertices[corners[k]];
      block.normal[k][i] = plane.normal[static_cast<int>(k)];
      block.u[k][i] = corner[plane.u];
      block.v[k][i] = corner[plane.v];
    }
    block.offset[i] = plane.offset;
    block.u_is_y |= static_cast<std::uint8_t>(plane.u << i);
    block.v_is_y |= static_cast<std::uint8_t>((plane.v & 1) << i);
  }
  return block;
}

/// A line from the first corner through the point meets the opposite edge at `v` of its length; the point lies at `u`
/// of the way there.
Vec3 MeshFaces::normal(const Vec3& point, std::uint32_t index) const {
  const Plane plane = plane_of(index);
  if (parameters_.face_normals.empty() || parameters_.face_normals[index] == MeshParameters::kNoCorners) {
    return Vec3(plane.normal);
  }
  Corners corners = parameters_.faces[index];
  Corners normals = parameters_.face_normals[index];
  if (plane.swapped) {
    std::swap(corners[0], corners[1]);
    std::swap(normals[0], normals[1]);
  }
  const Vec3 a = vertex(corners[0]);
  const Vec3 b = vertex(corners[1]);
  const Vec3 c = vertex(corners[2]);
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

Vec2 MeshFaces::uv(const Vec3& point, std::uint32_t index) const {
  if (parameters_.face_uvs.empty()) return Vec2(0.0);
  const Corners& uvs = parameters_.face_uvs[index];
  const std::array<double, 3> weights = barycentric(point, parameters_.faces[index]);
  Vec2 uv(0.0);
  for (std::size_t i = 0; i < 3; ++i) uv += parameters_.uv[uvs[i]] * weights[i];
  return uv;
}

/// How near the point is to each corner: 1 there, 0 on the opposite edge.
std::array<double, 3> MeshFaces::barycentric(const Vec3& point, const Corners& corners) const {
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

}  // namespace firstlight::render
