#include "render/scene/solid.h"

#include "render/math/interrupt.h"
#include "render/scene/solid_structure.h"
#include "render/shape/plane.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace firstlight::render {
namespace {

/// Room that a box gets for the rounding of crossings and of box tests, relative to its largest coordinate.
constexpr double kBoxRoom = 2e-6;
/// And at least, in scene units: a point is off by some 2^-52 of where its ray begins and of how long it is, however
/// near to 0 the box lies. Rays are followed for 1e7, so this is a hundred times what they are off by.
constexpr double kLeastRoom = 1e-6;
Box3 roomy(const Box3& box) { return padded(box, kBoxRoom, kLeastRoom); }

bool is_within(const Box3& inner, const Box3& outer) {
  return inner.isEmpty() || (outer.intersects(inner.min) && outer.intersects(inner.max));
}

bool inside_all(const std::vector<Solid>& solids, const Vec3& point) {
  return std::all_of(solids.begin(), solids.end(), [&](const Solid& s) { return s.inside(point); });
}

/// Whether the ray meets the bounding object or starts in it. `scratch` is returned as it came.
bool reaches(const Ray& ray, const Solid& bound, const Box3& box, std::uint8_t hidden_bit,
             std::vector<Crossing>& scratch) {
  const auto mark = static_cast<std::ptrdiff_t>(scratch.size());
  if (meets(ray, box)) bound.crossings(ray, hidden_bit, scratch);
  const bool met =
      std::any_of(scratch.begin() + mark, scratch.end(), [](const Crossing& c) { return c.depth >= kNearestBound; });
  scratch.resize(static_cast<std::size_t>(mark));
  return met || bound.inside(ray.origin);
}

std::vector<Box3> boxes_of(const std::vector<Solid>& solids) {
  std::vector<Box3> boxes;
  boxes.reserve(solids.size());
  for (const Solid& solid : solids) boxes.push_back(solid.box());
  return boxes;
}

/// Removes from `out`, from index `first` on, what `belongs` refuses; keeps the order. Of many crossings each may ask
/// for many solids.
template <class Belongs>
void keep_if(std::vector<Crossing>& out, std::size_t first, const Belongs& belongs) {
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  constexpr unsigned kCrossingsBetween = 8;
  unsigned count = 0;
  bool leave = false;
  const auto refuses = [&](const Crossing& c) {
    leave = leave || (++count % kCrossingsBetween == 0 && Interrupt::asked());
    return leave || !belongs(c);
  };
  out.erase(std::remove_if(begin, out.end(), refuses), out.end());
}

/// POV-Ray moves the crossings of each member from one stack to another, which turns their order around; equal depths
/// are decided by that order.
void turn_around(std::vector<Crossing>& out, std::size_t first) {
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
}

/// From this many members on a tree over their boxes finds the few that matter.
constexpr std::size_t kManyMembers = 12;

/// Members to be asked, of all solids that are being asked at the moment; each takes its place at the end.
thread_local std::vector<std::uint32_t> members_to_ask;

}  // namespace

/// Finds the boxes of what the members make together.
void Solid::Structure::close_members(Kind kind) {
  member_boxes = boxes_of(members);
  member_reaches.clear();
  for (const Solid& member : members) member_reaches.push_back(member.reach());
  box = Box3();
  if (kind == Kind::intersection) {
    // A crossing of one member counts only inside all others, so it lies where all of them reach.
    reach = {boundless_box(), Box3()};
    for (const Reach& member : member_reaches) {
      reach.inside = overlap(reach.inside, member.inside);
      reach.outside.extendBy(member.outside);
    }
    for (const Box3& member : member_boxes) {
      const Box3 part = overlap(member, reach.inside);
      if (!part.isEmpty()) box.extendBy(part);
    }
  } else {
    reach = {Box3(), boundless_box()};
    for (const Reach& member : member_reaches) {
      reach.inside.extendBy(member.inside);
      reach.outside = overlap(reach.outside, member.outside);
    }
    for (const Box3& member : member_boxes) box.extendBy(member);
  }
  trees.reset();
  if (members.size() >= kManyMembers) plant_trees(kind);
}

void Solid::Structure::plant_trees(Kind kind) {
  std::vector<Box3> deciding;
  for (const Reach& member : member_reaches) {
    // Away from these boxes a point is outside every member of a union, or inside every member of an intersection.
    deciding.push_back(kind == Kind::intersection ? member.outside : member.inside);
  }
  trees = std::make_shared<MemberTrees>(MemberTrees{BoxTree(member_boxes), BoxTree(deciding)});
}

const std::vector<Solid>& Solid::members() const { return structure_->members; }
const std::vector<Solid>& Solid::clips() const { return structure_->clips; }
const std::vector<Solid>& Solid::bounds() const { return structure_->bounds; }

void Solid::set_members(std::vector<Solid> members) {
  if (!members.empty() || !is_plain()) structure_.change().members = std::move(members);
}

void Solid::set_clips(std::vector<Solid> clips) {
  if (!clips.empty() || !is_plain()) structure_.change().clips = std::move(clips);
}

void Solid::set_bounds(std::vector<Solid> bounds) {
  if (!bounds.empty() || !is_plain()) structure_.change().bounds = std::move(bounds);
}

Reach Solid::reach() const {
  if (!is_plain()) return structure_->reach;
  return {roomy(shape->inside_bounds()), roomy(shape->outside_bounds())};
}

Box3 Solid::box() const { return is_cramped() ? *structure_->given_box : surface_box(); }

Box3 Solid::surface_box() const { return is_plain() ? roomy(shape->bounds()) : structure_->box; }

Extent Solid::extent() const {
  if (is_plain()) return render::extent(*shape);
  return structure_->extent ? *structure_->extent : Extent(structure_->box);
}

void Solid::set_extent(const Extent& extent) {
  const Box3 given = roomy(extent.reach());
  const bool is_cramped = !is_within(box(), roomy(given));  // single precision takes less than the room
  if (is_plain() && !is_cramped) return;
  const bool was_plain = is_plain();
  structure_.change().extent = extent;
  if (was_plain) close();
  if (is_cramped) structure_.change().given_box = given;
}

bool Solid::is_cramped() const { return !is_plain() && structure_->given_box.has_value(); }

void Solid::close() {
  if (is_plain()) return;
  Structure& structure = structure_.change();
  if (kind == Kind::shape) {
    structure.box = roomy(shape->bounds());
    structure.reach = {roomy(shape->inside_bounds()), roomy(shape->outside_bounds())};
  } else {
    structure.close_members(kind);
  }
  structure.bound_boxes = boxes_of(structure.bounds);
  structure.levels = 1;
  structure.hides_some = false;
  for (const auto* within : {&structure.members, &structure.clips, &structure.bounds}) {
    for (const Solid& solid : *within) {
      structure.levels = std::max(structure.levels, 1 + solid.structure_->levels);
      structure.hides_some = structure.hides_some || solid.hidden_from != 0 || solid.structure_->hides_some;
    }
  }
  for (const Solid& clip : structure.clips) {
    const Reach reach = clip.reach();
    structure.box = overlap(structure.box, reach.inside);
    structure.reach.inside = overlap(structure.reach.inside, reach.inside);
    structure.reach.outside.extendBy(reach.outside);
  }
}

/// Whether `point` is in a member; its boxes are asked first.
bool Solid::member_holds(std::size_t index, const Vec3& point) const {
  const Structure& structure = *structure_;
  const Reach& reach = structure.member_reaches[index];
  if (!reach.inside.intersects(point)) return false;
  return !reach.outside.intersects(point) || structure.members[index].inside(point);
}

bool Solid::inside_all_members(const Vec3& point, const Solid* but) const {
  const Structure& structure = *structure_;
  const auto refuses = [&](std::size_t i) { return &structure.members[i] != but && !member_holds(i, point); };
  if (structure.trees) return !structure.trees->deciding.any_around(point, refuses);
  for (std::size_t i = 0; i < structure.members.size(); ++i) {
    if (refuses(i)) return false;
  }
  return true;
}

bool Solid::inside_any_member(const Vec3& point, const Solid* but, std::uint8_t hiding) const {
  const Structure& structure = *structure_;
  const auto holds = [&](std::size_t i) {
    const Solid& member = structure.members[i];
    return &member != but && (member.hidden_from & hiding) == 0 && member_holds(i, point);
  };
  if (structure.trees) return structure.trees->deciding.any_around(point, holds);
  for (std::size_t i = 0; i < structure.members.size(); ++i) {
    if (holds(i)) return true;
  }
  return false;
}

void Solid::add_shape_crossings(const Ray& ray, std::vector<Crossing>& out) const {
  const std::size_t first = out.size();
  shape->crossings(ray, out);
  for (std::size_t i = first; i < out.size(); ++i) out[i].part = part;
}

void Solid::add_member_crossings(const Solid& member, const Ray& ray, std::uint8_t hidden_bit, std::uint8_t hiding,
                                 std::vector<Crossing>& out) const {
  if ((member.hidden_from & hiding) != 0) return;
  const std::size_t start = out.size();
  member.crossings(ray, hidden_bit, out);
  if (kind == Kind::intersection) {
    keep_if(out, start, [&](const Crossing& c) { return inside_all_members(ray.at(c.depth), &member); });
  } else if (kind == Kind::merge) {
    keep_if(out, start, [&](const Crossing& c) { return !inside_any_member(ray.at(c.depth), &member, hiding); });
  }
  if (kind != Kind::union_ || !structure_->clips.empty()) turn_around(out, start);
}

/// Whether the ray reaches all that bounds the solid. `scratch` is returned as it came.
bool Solid::reaches_bounds(const Ray& ray, std::uint8_t hidden_bit, std::vector<Crossing>& scratch) const {
  const Structure& structure = *structure_;
  for (std::size_t i = 0; i < structure.bounds.size(); ++i) {
    if (!reaches(ray, structure.bounds[i], structure.bound_boxes[i], hidden_bit, scratch)) return false;
  }
  return true;
}

void Solid::crossings(const Ray& ray, std::uint8_t hidden_bit, std::vector<Crossing>& out) const {
  if (is_plain()) return add_shape_crossings(ray, out);
  if (Interrupt::asked()) return;
  const Structure& structure = *structure_;
  if (!reaches_bounds(ray, hidden_bit, out)) return;
  const std::size_t first = out.size();
  if (kind == Kind::shape) add_shape_crossings(ray, out);
  const std::uint8_t hiding = hiding_in(kind, hidden_bit);
  if (structure.trees) {
    const std::size_t mark = members_to_ask.size();
    structure.trees->surface.met_by(ray, members_to_ask);
    // In the order of the members, which decides equal depths.
    std::sort(members_to_ask.begin() + static_cast<std::ptrdiff_t>(mark), members_to_ask.end());
    const std::size_t end = members_to_ask.size();
    for (std::size_t i = mark; i < end && !Interrupt::asked(); ++i) {
      add_member_crossings(structure.members[members_to_ask[i]], ray, hidden_bit, hiding, out);
    }
    members_to_ask.resize(mark);
  } else {
    const Solid* member = structure.members.data();
    for (const Box3& box : structure.member_boxes) {
      if (meets(ray, box)) add_member_crossings(*member, ray, hidden_bit, hiding, out);
      ++member;
    }
  }
  if (!structure.clips.empty()) {
    keep_if(out, first, [&](const Crossing& c) { return inside_all(structure.clips, ray.at(c.depth)); });
  }
}

void Solid::nearest(const Ray& ray, std::uint8_t hidden_bit, double low, double high,
                    std::vector<Crossing>& out) const {
  if (kind != Kind::shape || !structure_->clips.empty()) return crossings(ray, hidden_bit, out);
  if (!is_plain() && !reaches_bounds(ray, hidden_bit, out)) return;
  const std::size_t first = out.size();
  shape->nearest(ray, low, high, out);
  for (std::size_t i = first; i < out.size(); ++i) out[i].part = part;
}

bool Solid::inside(const Vec3& point) const {
  if (is_plain()) return shape->inside(point);
  const Structure& structure = *structure_;
  if (!structure.reach.inside.intersects(point)) return false;
  if (!structure.reach.outside.intersects(point)) return true;
  return inside_all(structure.clips, point) && inside_unclipped(point);
}

std::optional<Extent> Solid::start_extent() const {
  if (!is_plain()) return structure_->extent;
  return dynamic_cast<const Plane*>(shape.get()) != nullptr ? std::nullopt : std::optional(extent());
}

bool Solid::holds_start(const Vec3& point) const {
  const std::optional<Extent> extent = start_extent();
  return (!extent || extent->holds(point)) && inside_without_clips(point);
}

bool Solid::inside_without_clips(const Vec3& point) const {
  return is_plain() ? shape->inside(point) : inside_unclipped(point);
}

bool Solid::may_hold_start(const Box3& points) const {
  const std::optional<Extent> extent = start_extent();
  return !extent || extent->meets(points);
}

/// Pre: not plain.
bool Solid::inside_unclipped(const Vec3& point) const {
  switch (kind) {
    case Kind::shape:
      return shape->inside(point);
    case Kind::intersection:
      return inside_all_members(point, nullptr);
    case Kind::union_:
    case Kind::merge:
      break;
  }
  return inside_any_member(point, nullptr, 0);
}

}  // namespace firstlight::render
