#include "render/accel/leaves.h"

#include "render/math/interrupt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace firstlight::render {
namespace {

bool any_opaque(const Solid& solid, const std::vector<Part>& parts) {
  if (solid.kind == Solid::Kind::shape) return parts[solid.part].opaque;
  return std::ranges::any_of(solid.members(), [&](const Solid& m) { return any_opaque(m, parts); });
}

void add_blockers(const Solid& solid, std::vector<const Solid*>& blockers) {
  if (solid.kind == Solid::Kind::union_ && solid.clips().empty()) {
    for (const Solid& member : solid.members()) add_blockers(member, blockers);
  } else {
    blockers.push_back(&solid);
  }
}

/// Those that cast shadows also where the feeler misses the box of a cramped solid.
/// Source   POV-Ray 3.7 asks the object that blocked a light last before all others, and then not the box of the
///          whole, but that of the member alone, if its kind of shape asks it. So nearly all feelers meet it without
///          the box. Which do not depends on the order of the pixels there; here all do, but of planes, whose shadows
///          would be everywhere, none.
std::vector<const Solid*> blockers_of(const Solid& cramped) {
  std::vector<const Solid*> blockers;
  if (cramped.kind == Solid::Kind::shape && !cramped.shape->asks_box()) blockers.push_back(&cramped);
  if (cramped.kind == Solid::Kind::union_ && cramped.clips().empty()) add_blockers(cramped, blockers);
  return blockers;
}

ChildRef next_ref(ChildKind kind, std::size_t index) { return ChildRef::of(kind, static_cast<std::uint32_t>(index)); }

SphereGroup group_of_one(std::uint32_t sphere) {
  SphereGroup group;
  group.fill(kNoSphere);
  group[0] = sphere;
  return group;
}

}  // namespace

Leaves::Leaves(const Scene& scene) : tie_order(scene) {
  opaque_parts.reserve(scene.parts.size());
  for (const Part& part : scene.parts) opaque_parts.push_back(part.opaque);

  std::vector<TreeItem> items;
  std::vector<ChildRef> outside;
  std::vector<RoundSphere> round;
  constexpr std::size_t kSolidsBetween = 4096;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    if (i % kSolidsBetween == 0 && Interrupt::asked()) return;
    const Solid& solid = scene.solids[i];
    const Box3 world_box = solid.box();
    if (world_box.isEmpty()) continue;
    LeafHead head;
    head.solid = static_cast<std::uint32_t>(i);
    head.hidden_from = solid.hidden_from;
    head.opaque = any_opaque(solid, scene.parts);
    ChildRef ref{0};
    if (solid.is_plain()) {
      head.shape = solid.shape.get();
      head.part = solid.part;
    }
    if (const auto* plane = dynamic_cast<const Plane*>(head.shape)) {
      planes.push_back({plane->unit_normal(), plane->offset(), head});
      continue;
    }
    const FloatBox bounds(world_box);
    if (const auto* sphere = dynamic_cast<const Sphere*>(head.shape)) {
      ref = next_ref(ChildKind::sphere, round.size());
      round.push_back({sphere, bounds, head});
    } else if (const auto* box = dynamic_cast<const Box*>(head.shape)) {
      ref = next_ref(ChildKind::box, boxes.size());
      boxes.push_back({box->axis_box(), bounds, head});
    } else {
      ref = next_ref(ChildKind::solid, solids.size());
      solids.push_back({&solid, bounds, head, solid.is_cramped(), false});
    }
    if (WideTree::fits(world_box)) {
      items.push_back({world_box, ref});
    } else {
      outside.push_back(ref);
    }
    if (!solid.is_cramped()) continue;
    for (const Solid* blocker : blockers_of(solid)) {
      head.opaque = any_opaque(*blocker, scene.parts);
      const Box3 blocker_box = blocker->surface_box();
      if (!head.opaque || !is_bounded(blocker_box) || overlap(blocker_box, world_box).isEmpty()) continue;
      ref = next_ref(ChildKind::solid, solids.size());
      solids.push_back({blocker, FloatBox(blocker_box), head, false, true});
      if (WideTree::fits(blocker_box)) {
        items.push_back({blocker_box, ref});
      } else {
        outside.push_back(ref);
      }
    }
  }
  mark_coincident(planes);
  tree = WideTree(items);
  if (Interrupt::asked()) return;
  if (!tree.built()) {
    for (const TreeItem& item : items) outside.push_back(item.leaf);
  }
  for (const SphereGroup& group : tree.sphere_groups()) add_block(round, group);
  for (const ChildRef ref : outside) {
    if (ref.kind() == ChildKind::sphere) {
      beside.push_back(next_ref(ChildKind::sphere, sphere_blocks.size()));
      add_block(round, group_of_one(ref.index()));
    } else {
      beside.push_back(ref);
    }
  }
}

void mark_coincident(std::span<PlaneLeaf> planes) {
  constexpr double kRoom = 1e-6;
  constexpr std::size_t kMany = 1000;  // so many are not compared with each other: all are in doubt
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes.size() > kMany) planes[i].in_doubt = true;
    for (std::size_t k = 0; k < i && planes.size() <= kMany; ++k) {
      PlaneLeaf& a = planes[i];
      PlaneLeaf& b = planes[k];
      const double side = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
      const bool parallel = (a.normal - b.normal * side).length2() < kRoom * kRoom;
      const bool together = std::abs(a.offset - b.offset * side) <= kRoom * (1.0 + std::abs(a.offset));
      if (parallel && together) a.in_doubt = b.in_doubt = true;
    }
  }
}

void Leaves::add_block(const std::vector<RoundSphere>& all, const SphereGroup& group) {
  SphereBlock block{};
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    block.radius_squared[lane] = -std::numeric_limits<double>::infinity();
    spheres.emplace_back();
    if (group[lane] == kNoSphere) continue;
    const RoundSphere& round = all[group[lane]];
    spheres.back() = round.head;
    for (int axis = 0; axis < 3; ++axis) {
      block.center[axis][lane] = round.sphere->center()[axis];
      block.bounds[2 * axis][lane] = round.bounds.low[axis];
      block.bounds[2 * axis + 1][lane] = round.bounds.high[axis];
    }
    block.hidden_from[lane] = round.head.hidden_from;
    block.hidden_from_any |= round.head.hidden_from;
    block.opaque |= static_cast<std::uint8_t>(round.head.opaque ? 1u << lane : 0u);
    block.radius_squared[lane] = round.sphere->radius_squared();
  }
  sphere_blocks.push_back(block);
}

}  // namespace firstlight::render
