#include "render/scene/solid.h"

#include <algorithm>
#include <cstddef>

namespace firstlight::render {
namespace {

/// Room that a box gets for the rounding of crossings and of box tests, relative to its largest coordinate.
constexpr double kBoxRoom = 2e-6;
/// A bounding object counts as met from this depth on. [POV-Ray 3.7]
constexpr double kNearestBound = 1e-4;

// How members hide is POV-Ray 3.7's rule: a union asks for no_reflection only (no_image of a member does not hide it
// from the camera), a merge asks for both, an intersection for none, and no_shadow counts for whole objects alone.
constexpr std::uint8_t kHidesInUnion = kHiddenFromReflection;
constexpr std::uint8_t kHidesInMerge = kHiddenFromPrimary | kHiddenFromReflection;

bool inside_all(const std::vector<Solid>& solids, const Vec3& point) {
  return std::all_of(solids.begin(), solids.end(), [&](const Solid& s) { return s.inside(point); });
}

/// Whether the ray meets the bounding object or starts in it. `scratch` is returned as it came.
bool reaches(const Ray& ray, const Solid& bound, std::uint8_t hidden_bit, std::vector<Crossing>& scratch) {
  const auto mark = static_cast<std::ptrdiff_t>(scratch.size());
  if (meets(ray, bound.box)) bound.crossings(ray, hidden_bit, scratch);
  const bool met =
      std::any_of(scratch.begin() + mark, scratch.end(), [](const Crossing& c) { return c.depth >= kNearestBound; });
  scratch.resize(static_cast<std::size_t>(mark));
  return met || bound.inside(ray.origin);
}

/// Removes from `out`, from index `first` on, what `belongs` refuses; keeps the order.
template <class Belongs>
void keep_if(std::vector<Crossing>& out, std::size_t first, const Belongs& belongs) {
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(first);
  out.erase(std::remove_if(begin, out.end(), [&](const Crossing& c) { return !belongs(c); }), out.end());
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

void Solid::close() {
  switch (kind) {
    case Kind::shape:
      box = padded(shape->bounds(), kBoxRoom);
      inside_box = padded(shape->inside_bounds(), kBoxRoom);
      outside_box = padded(shape->outside_bounds(), kBoxRoom);
      break;
    case Kind::union_:
    case Kind::merge:
      box = Box3();
      inside_box = Box3();
      outside_box = boundless_box();
      for (const Solid& member : members) {
        box.extendBy(member.box);
        inside_box.extendBy(member.inside_box);
        outside_box = overlap(outside_box, member.outside_box);
      }
      break;
    case Kind::intersection: {
      // A crossing of one member counts only inside all others, so it lies where all of them reach.
      inside_box = boundless_box();
      outside_box = Box3();
      for (const Solid& member : members) {
        inside_box = overlap(inside_box, member.inside_box);
        outside_box.extendBy(member.outside_box);
      }
      box = Box3();
      for (const Solid& member : members) {
        const Box3 part = overlap(member.box, inside_box);
        if (!part.isEmpty()) box.extendBy(part);
      }
      break;
    }
  }
  for (const Solid& clip : clips) {
    box = overlap(box, clip.inside_box);
    inside_box = overlap(inside_box, clip.inside_box);
    outside_box.extendBy(clip.outside_box);
  }
  trees_.reset();
  if (members.size() >= kManyMembers) plant_trees();
}

void Solid::plant_trees() {
  std::vector<Box3> surface;
  std::vector<Box3> deciding;
  for (const Solid& member : members) {
    surface.push_back(member.box);
    // Away from these boxes a point is outside every member of a union, or inside every member of an intersection.
    deciding.push_back(kind == Kind::intersection ? member.outside_box : member.inside_box);
  }
  trees_ = std::make_shared<MemberTrees>(MemberTrees{BoxTree(surface), BoxTree(deciding)});
}

bool Solid::inside_all_members(const Vec3& point, const Solid* but) const {
  const auto refuses = [&](const Solid& m) { return &m != but && !m.inside(point); };
  if (trees_) return !trees_->deciding.any_around(point, [&](std::uint32_t i) { return refuses(members[i]); });
  return std::none_of(members.begin(), members.end(), refuses);
}

bool Solid::inside_any_member(const Vec3& point, const Solid* but, std::uint8_t hiding) const {
  const auto holds = [&](const Solid& m) { return &m != but && (m.hidden_from & hiding) == 0 && m.inside(point); };
  if (trees_) return trees_->deciding.any_around(point, [&](std::uint32_t i) { return holds(members[i]); });
  return std::any_of(members.begin(), members.end(), holds);
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
  if (kind != Kind::union_ || !clips.empty()) turn_around(out, start);
}

void Solid::crossings(const Ray& ray, std::uint8_t hidden_bit, std::vector<Crossing>& out) const {
  for (const Solid& bound : bounds) {
    if (!reaches(ray, bound, hidden_bit, out)) return;
  }
  const std::size_t first = out.size();
  if (kind == Kind::shape) {
    shape->crossings(ray, out);
    for (std::size_t i = first; i < out.size(); ++i) out[i].part = part;
  }
  const std::uint8_t hiding = kind == Kind::union_  ? kHidesInUnion & hidden_bit
                              : kind == Kind::merge ? kHidesInMerge & hidden_bit
                                                    : 0;
  if (trees_) {
    const std::size_t mark = members_to_ask.size();
    trees_->surface.met_by(ray, members_to_ask);
    // In the order of the members, which decides equal depths.
    std::sort(members_to_ask.begin() + static_cast<std::ptrdiff_t>(mark), members_to_ask.end());
    const std::size_t end = members_to_ask.size();
    for (std::size_t i = mark; i < end; ++i) {
      add_member_crossings(members[members_to_ask[i]], ray, hidden_bit, hiding, out);
    }
    members_to_ask.resize(mark);
  } else {
    for (const Solid& member : members) {
      if (meets(ray, member.box)) add_member_crossings(member, ray, hidden_bit, hiding, out);
    }
  }
  if (!clips.empty()) keep_if(out, first, [&](const Crossing& c) { return inside_all(clips, ray.at(c.depth)); });
}

bool Solid::inside(const Vec3& point) const {
  if (!inside_box.intersects(point)) return false;
  if (!outside_box.intersects(point)) return true;
  if (!inside_all(clips, point)) return false;
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
