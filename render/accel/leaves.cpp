#include "render/accel/leaves.h"

#include "render/math/interrupt.h"
#include "render/shape/box.h"
#include "render/shape/plane.h"
#include "render/shape/sphere.h"

#include <algorithm>

namespace firstlight::render {
namespace {

bool any_opaque(const Solid& solid, const std::vector<Part>& parts) {
  if (solid.kind == Solid::Kind::shape) return parts[solid.part].opaque;
  return std::ranges::any_of(solid.members(), [&](const Solid& m) { return any_opaque(m, parts); });
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
      solids.push_back({&solid, bounds, head, solid.is_cramped(), solid.suits_blocks(), false});
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
      solids.push_back({blocker, FloatBox(blocker_box), head, false, blocker->suits_blocks(), true});
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

void Leaves::add_block(std::span<const RoundSphere> all, const SphereGroup& group) {
  sphere_blocks.push_back(sphere_block(all, group));
  for (const std::uint32_t sphere : group) spheres.push_back(sphere == kNoSphere ? LeafHead() : all[sphere].head);
}

}  // namespace firstlight::render
