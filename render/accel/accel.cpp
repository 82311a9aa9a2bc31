#include "render/accel/accel.h"

#include "render/accel/leaves.h"

#include <algorithm>

namespace firstlight::render {
namespace {

bool any_opaque(const Solid& solid, const std::vector<Part>& parts) {
  if (solid.kind == Solid::Kind::shape) return parts[solid.part].opaque;
  return std::any_of(solid.members.begin(), solid.members.end(), [&](const Solid& m) { return any_opaque(m, parts); });
}

ChildRef next_ref(ChildKind kind, std::size_t index) { return ChildRef::of(kind, static_cast<std::uint32_t>(index)); }

}  // namespace

Leaves::Leaves(const Scene& scene) {
  opaque_parts.reserve(scene.parts.size());
  for (const Part& part : scene.parts) opaque_parts.push_back(part.opaque);

  std::vector<TreeItem> items;
  for (std::size_t i = 0; i < scene.solids.size(); ++i) {
    const Solid& solid = scene.solids[i];
    if (solid.box.isEmpty()) continue;
    LeafHead head;
    head.solid = static_cast<std::uint32_t>(i);
    head.hidden_from = solid.hidden_from;
    head.opaque = any_opaque(solid, scene.parts);
    ChildRef ref{0};
    const bool plain = solid.kind == Solid::Kind::shape && solid.clips.empty() && solid.bounds.empty();
    if (plain) {
      head.shape = solid.shape.get();
      head.part = solid.part;
    }
    if (const auto* plane = dynamic_cast<const Plane*>(head.shape)) {
      planes.push_back({plane, head});
      continue;
    }
    if (const auto* sphere = dynamic_cast<const Sphere*>(head.shape)) {
      ref = next_ref(ChildKind::sphere, spheres.size());
      spheres.push_back({sphere->center(), sphere->radius_squared(), head});
    } else if (const auto* box = dynamic_cast<const Box*>(head.shape)) {
      ref = next_ref(ChildKind::box, boxes.size());
      boxes.push_back({box->axis_box(), head});
    } else {
      ref = next_ref(ChildKind::solid, solids.size());
      solids.push_back({&solid, head});
    }
    if (WideTree::fits(solid.box)) {
      items.push_back({solid.box, ref});
    } else {
      beside.push_back(ref);
    }
  }
  tree = WideTree(items);
  if (!tree.built()) {
    for (const TreeItem& item : items) beside.push_back(item.leaf);
  }
}

struct Accel::Impl {
  explicit Impl(const Scene& scene) : leaves(scene) {}
  Leaves leaves;
};

Accel::Accel(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;
Accel& Accel::operator=(Accel&&) noexcept = default;

void Accel::closest(std::span<const RayQuery> queries, std::span<Hit> hits) const {
  find_closest(impl_->leaves, queries, hits);
}

void Accel::occluded(std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) const {
  find_occluded(impl_->leaves, queries, blocked);
}

}  // namespace firstlight::render
