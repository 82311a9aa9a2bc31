// How rays meet the faces of a mesh: together through the tree, and one ray and eight faces at a time.
#include "render/shape/mesh_faces.h"
#include "render/shape/tolerance.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/mesh_meet.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"
#include "render/math/ray_tree-inl.h"
#include "render/shape/lane_shape-inl.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Rounding of depths there and back, and of those that are equal in the one space and not in the other.
constexpr double kRounding = 1e-12;

/// Numbers in single precision as lanes.
HWY_INLINE Lanes promoted(const float* from) {
  const hn::Rebind<float, LaneTag> narrow;
  return hn::PromoteTo(LaneTag(), hn::LoadU(narrow, from));
}

/// Whether a point of the projection is outside of an edge.
HWY_INLINE LanesMask beyond_edge(const Lanes& from_u, const Lanes& from_v, const Lanes& to_u, const Lanes& to_v,
                                 const Lanes& u, const Lanes& v) {
  return (to_u - u) * (to_v - from_v) < (to_v - v) * (to_u - from_u);
}

/// Calls visit(depth, place) for the faces of the block that a ray with a direction of unit length meets.
template <class Visit>
HWY_INLINE void meet_block(const MeshFaces::Block& block, const Ray& ray, const Visit& visit) {
  for (std::size_t i = 0; i < MeshFaces::Block::kSize; i += Lanes::kCount) {
    const Vec3Of<Lanes> normal{promoted(block.normal[0] + i), promoted(block.normal[1] + i),
                               promoted(block.normal[2] + i)};
    const auto origin = everywhere<Lanes>(ray.origin), direction = everywhere<Lanes>(ray.direction);
    const Lanes approach = dot(normal, direction);
    const Lanes depth = -(promoted(block.offset + i) + dot(normal, origin)) / approach;
    const auto counts = (abs(approach) >= kEpsilon) & (depth >= kNearestCrossing) & (depth <= kMaxDistance);
    if (!any(counts)) continue;
    const auto u_is_y = Lanes::mask_of(block.u_is_y >> i), v_is_y = Lanes::mask_of(block.v_is_y >> i);
    const Lanes u = select(u_is_y, origin.y, origin.x) + depth * select(u_is_y, direction.y, direction.x);
    const Lanes v = select(v_is_y, origin.y, origin.z) + depth * select(v_is_y, direction.y, direction.z);
    const Lanes u0 = promoted(block.u[0] + i), u1 = promoted(block.u[1] + i), u2 = promoted(block.u[2] + i);
    const Lanes v0 = promoted(block.v[0] + i), v1 = promoted(block.v[1] + i), v2 = promoted(block.v[2] + i);
    const auto outside =
        beyond_edge(u0, v0, u1, v1, u, v) | beyond_edge(u1, v1, u2, v2, u, v) | beyond_edge(u2, v2, u0, v0, u, v);
    unsigned met = bits(without(counts, outside));
    if (met == 0) continue;
    double depths[Lanes::kCount];
    depth.store(depths);
    for (; met != 0; met &= met - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(met));
      visit(depths[lane], block.face[i + lane]);
    }
  }
}

void meet_all(const MeshFaces& faces, const Ray& given, std::vector<FaceMet>& out) {
  const UnitRay unit(given);
  const RayColumns rays = alone(unit.ray);
  const std::size_t first = out.size();
  TreeWalk(faces.tree(), rays)
      .walk(
          1, alone(kMaxDistance),
          [&](std::uint32_t leaf, std::uint64_t) HWY_ATTR {
            meet_block(faces.block(leaf), unit.ray, [&](double depth, std::uint32_t face) {
              out.push_back({depth / unit.length, face});
            });
          },
          [&](std::uint32_t leaf) HWY_ATTR { fetch_ahead(faces.block(leaf)); });
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
            [](const FaceMet& a, const FaceMet& b) { return a.face < b.face; });
}

std::uint64_t meet_nearest(const MeshFaces& faces, const RaysAndPlace& asked, Column<double>& depth,
                           Column<double>& face) {
  const DepthWindow& window = *asked.nearest_only;
  RayColumns own;
  Column<double> lengths, limits;
  for_each_vector(asked, [&](const RayOf<Lanes>& ray, std::size_t i, std::uint64_t) HWY_ATTR {
    const UnitRayOf<Lanes> unit = unit_ray(ray);
    store3(unit.ray.origin, own.origin, i);
    store3(unit.ray.direction, own.direction, i);
    store(unit.length, lengths, i);
    const auto high = load<Lanes>(window.high, i);
    store(high, depth, i);
    store(min(Lanes(kMaxDistance), high * unit.length * (1.0 + kRounding)), limits, i);
  });
  std::uint64_t found = 0;
  TreeWalk walk(faces.tree(), own);
  walk.walk(
      asked.who, limits,
      [&](std::uint32_t leaf, std::uint64_t rays) HWY_ATTR {
        const MeshFaces::Block& block = faces.block(leaf);
        for (; rays != 0; rays &= rays - 1) {
          const auto i = static_cast<std::size_t>(__builtin_ctzll(rays));
          meet_block(block, own.ray(i), [&](double there, std::uint32_t of_face) HWY_ATTR {
            if (!(there <= limits[i])) return;
            const double here = there / lengths[i];
            if (!(here > window.low[i] && here <= depth[i])) return;
            const std::uint64_t bit = std::uint64_t{1} << i;
            if (here == depth[i] && (found & bit) != 0 && face[i] > of_face) return;
            found |= bit;
            depth[i] = here;
            face[i] = of_face;
            limits[i] = std::min(limits[i], there * (1.0 + kRounding));
            walk.look_up_to(i, limits[i]);
          });
        }
      },
      [&](std::uint32_t leaf) HWY_ATTR { fetch_ahead(faces.block(leaf)); });
  return found;
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(meet_all);
HWY_EXPORT(meet_nearest);

void MeshFaces::meet(const Ray& ray, std::vector<FaceMet>& out) const {
  HWY_DYNAMIC_DISPATCH(meet_all)(*this, ray, out);
}

std::uint64_t MeshFaces::meet_nearest(const RaysAndPlace& asked, Column<double>& depth, Column<double>& face) const {
  return HWY_DYNAMIC_DISPATCH(meet_nearest)(*this, asked, depth, face);
}

}  // namespace firstlight::render
#endif
