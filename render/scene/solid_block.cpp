// How a block of rays meets a solid. Every crossing of every shape gets its place in a slot; then each ray looks at its
// own from the nearest on until one belongs to the surface. So inside tests are asked only of crossings that are nearer
// than what is seen, and of many rays at once.
#include "render/math/block_tests.h"
#include "render/math/interrupt.h"
#include "render/scene/solid.h"
#include "render/scene/solid_structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

/// Solids that lie deeper in each other are met ray by ray.
constexpr std::uint32_t kMostLevels = 32;

Column<double> everywhere(double value) {
  Column<double> column;
  column.at.fill(value);
  return column;
}

/// The window of what bounds a solid.
const DepthWindow& window_of_bounds() {
  static const Column<double> low = everywhere(std::nextafter(kNearestBound, 0.0));
  static const Column<double> high = everywhere(std::numeric_limits<double>::infinity());
  static const DepthWindow window{low, high};
  return window;
}

}  // namespace

/// One question to one solid.
class Solid::Meeting {
 public:
  Meeting(const BlockQuestion& question, std::uint8_t hidden_bit, Slots& slots)
      : question_(question),
        hidden_bit_(hidden_bit),
        opaque_parts_(question.opaque_parts),
        slots_(slots),
        visits_(visits_of_thread()),
        chosen_(chosen_of_thread()) {
    visits_.clear();
  }

  void find(const Solid& solid, std::uint64_t who, NearestCrossings& nearest) {
    gather(solid, who, &question_.window);
    resolve(0, 0, who, question_.window, nearest);
  }

 private:
  /// A solid that some rays were asked to meet, and the slots of what is within it. Those of its members follow it.
  struct Visit {
    const Solid* solid;
    std::size_t first, end;  ///< its slots
    std::size_t after;       ///< behind the last visit within it
    std::uint64_t own;       ///< rays whose crossing that is being looked at is within it
  };

  static std::vector<Visit>& visits_of_thread() {
    thread_local std::vector<Visit> visits;
    return visits;
  }
  static std::array<std::uint64_t, Slots::kMost>& chosen_of_thread() {
    thread_local std::array<std::uint64_t, Slots::kMost> chosen;
    return chosen;
  }

  void gather(const Solid& solid, std::uint64_t who, const DepthWindow* nearest_only);
  void gather_shape(const Solid& solid, std::uint64_t who, const DepthWindow* nearest_only);
  void gather_members(const Solid& solid, std::uint64_t who);
  void gather_member(const Solid& solid, const Solid& member, std::uint64_t who);
  std::uint64_t reaching_bounds(const Structure& structure, std::uint64_t who);
  std::uint64_t reaching(const Solid& bound, const Box3& box, std::uint64_t who);
  void resolve(std::size_t visit, std::size_t first, std::uint64_t who, const DepthWindow& window,
               NearestCrossings& nearest);
  void choose(const NearestCrossings& nearest, std::uint64_t who, std::size_t first);
  std::uint64_t survivors(std::size_t visit, const Columns3<double>& points, std::uint64_t who);

  const BlockQuestion& question_;
  const std::uint8_t hidden_bit_;
  const std::vector<bool>* opaque_parts_;
  Slots& slots_;
  std::vector<Visit>& visits_;
  std::array<std::uint64_t, Slots::kMost>& chosen_;  ///< of each slot, the rays whose crossing here is being looked at
};

/// Adds slots of all crossings that may belong to the solid's surface, and its visit.
void Solid::Meeting::gather(const Solid& solid, std::uint64_t who, const DepthWindow* nearest_only) {
  if (slots_.overflowed()) return;
  const std::size_t visit = visits_.size();
  visits_.push_back({&solid, slots_.size(), slots_.size(), visit + 1, 0});
  if (solid.is_plain()) {
    gather_shape(solid, who, nearest_only);
  } else {
    if (Interrupt::asked()) return;
    const Structure& structure = *solid.structure_;
    who = reaching_bounds(structure, who);
    visits_[visit].first = slots_.size();
    if (who == 0) {
      // Nothing of it is met.
    } else if (solid.kind == Kind::shape) {
      gather_shape(solid, who, structure.clips.empty() ? nearest_only : nullptr);
    } else {
      gather_members(solid, who);
    }
  }
  visits_[visit].end = slots_.size();
  visits_[visit].after = visits_.size();
}

void Solid::Meeting::gather_shape(const Solid& solid, std::uint64_t who, const DepthWindow* nearest_only) {
  if (opaque_parts_ != nullptr && !(*opaque_parts_)[solid.part]) return;
  const std::size_t first = slots_.size();
  solid.shape->meet_block(question_.rays, who, nearest_only, slots_);
  for (std::size_t s = first; s < slots_.size(); ++s) slots_[s].part = solid.part;
}

void Solid::Meeting::gather_members(const Solid& solid, std::uint64_t who) {
  const Structure& structure = *solid.structure_;
  if (structure.trees) {
    thread_local std::vector<std::pair<std::uint32_t, std::uint64_t>> to_ask;  // of all solids that are being asked
    const std::size_t mark = to_ask.size();
    structure.trees->surface.for_each_met(question_.rays, question_.inverse, who,
                                          [](std::uint32_t i, std::uint64_t rays) {
                                            to_ask.push_back({i, rays});
                                          });
    // In the order of the members, which decides equal depths.
    std::sort(to_ask.begin() + static_cast<std::ptrdiff_t>(mark), to_ask.end());
    const std::size_t end = to_ask.size();
    for (std::size_t i = mark; i < end && !Interrupt::asked(); ++i) {
      gather_member(solid, structure.members[to_ask[i].first], to_ask[i].second);
    }
    to_ask.resize(mark);
    return;
  }
  for (std::size_t i = 0; i < structure.members.size(); ++i) {
    const Box3& box = structure.member_boxes[i];
    gather_member(solid, structure.members[i],
                  is_bounded(box) ? meeting(question_.rays, question_.inverse, box, who) : who);
  }
}

void Solid::Meeting::gather_member(const Solid& solid, const Solid& member, std::uint64_t who) {
  if (who == 0 || (member.hidden_from & hiding_in(solid.kind, hidden_bit_)) != 0) return;
  const std::size_t visit = visits_.size();
  const std::size_t first = slots_.size();
  gather(member, who, nullptr);
  const std::size_t end = slots_.size();
  if (end == first) return visits_.resize(visit);
  // As one ray's list of crossings is turned around; see Solid::crossings().
  if (solid.kind == Kind::union_ && solid.structure_->clips.empty()) return;
  slots_.turn_around(first);
  for (std::size_t v = visit; v < visits_.size(); ++v) {
    visits_[v] = {visits_[v].solid, first + end - visits_[v].end, first + end - visits_[v].first, visits_[v].after, 0};
  }
}

std::uint64_t Solid::Meeting::reaching_bounds(const Structure& structure, std::uint64_t who) {
  for (std::size_t i = 0; i < structure.bounds.size() && who != 0 && !slots_.overflowed(); ++i) {
    who = reaching(structure.bounds[i], structure.bound_boxes[i], who);
  }
  return who;
}

/// Rays that meet the bounding object or start in it.
std::uint64_t Solid::Meeting::reaching(const Solid& bound, const Box3& box, std::uint64_t who) {
  const std::uint64_t starting = bound.inside(question_.rays.origin, who);
  const std::uint64_t outside = meeting(question_.rays, question_.inverse, box, who & ~starting);
  if (outside == 0) return starting;
  const std::size_t visit = visits_.size();
  const std::size_t first = slots_.size();
  const auto* opaque_parts = std::exchange(opaque_parts_, nullptr);
  gather(bound, outside, nullptr);
  NearestCrossings nearest;
  resolve(visit, first, outside, window_of_bounds(), nearest);
  opaque_parts_ = opaque_parts;
  slots_.cut(first);
  visits_.resize(visit);
  return starting | nearest.rays;
}

/// Finds the nearest crossing that belongs to the surface of the visited solid, whose slots begin with `first`, as all
/// that there are from it on.
void Solid::Meeting::resolve(std::size_t visit, std::size_t first, std::uint64_t who, const DepthWindow& window,
                             NearestCrossings& nearest) {
  const Solid& solid = *visits_[visit].solid;
  SlotSearch search(slots_, first);
  search.find(who, window, nearest);
  if (solid.is_plain() || (solid.kind == Kind::shape && solid.structure_->clips.empty())) return;
  std::uint64_t belonging = 0;
  std::uint64_t open = nearest.rays;
  NearestCrossings next;
  const NearestCrossings* looked_at = &nearest;
  while (open != 0 && !Interrupt::asked()) {
    Columns3<double> points;
    points_along(question_.rays, looked_at->depth, open, points);
    choose(*looked_at, open, first);
    const std::uint64_t found = survivors(visit, points, open);
    belonging |= found;
    for (std::uint64_t bits = looked_at == &next ? found : 0; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      nearest.depth[i] = next.depth[i];
      nearest.slot[i] = next.slot[i];
    }
    open &= ~found;
    if (open == 0) break;
    for (std::uint64_t bits = open; bits != 0; bits &= bits - 1) {
      const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
      search.leave_out(looked_at->slot_of(i), i);
    }
    search.find(open, window, next);
    looked_at = &next;
    open = next.rays;
  }
  nearest.rays = belonging;
}

/// Tells the slots from `first` on which of the rays in `who` look at them.
void Solid::Meeting::choose(const NearestCrossings& nearest, std::uint64_t who, std::size_t first) {
  std::fill(chosen_.begin() + static_cast<std::ptrdiff_t>(first),
            chosen_.begin() + static_cast<std::ptrdiff_t>(slots_.size()), 0);
  for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(bits));
    chosen_[nearest.slot_of(i)] |= std::uint64_t{1} << i;
  }
}

/// Returns those rays in `who`, which look at crossings within the visited solid, whose crossing, at `points`, belongs
/// to the solid's surface.
std::uint64_t Solid::Meeting::survivors(std::size_t visit, const Columns3<double>& points, std::uint64_t who) {
  const Solid& solid = *visits_[visit].solid;
  if (solid.is_plain()) return who;
  std::uint64_t left = who;
  if (solid.kind != Kind::shape) {
    left = 0;
    for (std::size_t v = visit + 1; v < visits_[visit].after; v = visits_[v].after) {
      std::uint64_t own = 0;
      for (std::size_t s = visits_[v].first; s < visits_[v].end; ++s) own |= chosen_[s];
      visits_[v].own = own & who;
      if (visits_[v].own != 0) left |= survivors(v, points, visits_[v].own);
    }
    // Visits are in the order of the members, some of which have none; members may be asked for in any order.
    const auto own = [&, v = visit + 1](const Solid& member) mutable {
      const std::size_t end = visits_[visit].after;
      if (v >= end || visits_[v].solid > &member) v = visit + 1;
      while (v < end && visits_[v].solid < &member) v = visits_[v].after;
      return v < end && visits_[v].solid == &member ? visits_[v].own : 0;
    };
    if (solid.kind == Kind::intersection) {
      left = solid.inside_all_members(points, left, own);
    } else if (solid.kind == Kind::merge) {
      left &= ~solid.inside_any_member(points, left, hiding_in(solid.kind, hidden_bit_), own);
    }
  }
  for (const Solid& clip : solid.structure_->clips) left = left == 0 ? 0 : clip.inside(points, left);
  return left;
}

bool Solid::meet(const BlockQuestion& question, std::uint8_t hidden_bit, std::uint64_t who, Slots& slots,
                 NearestCrossings& nearest) const {
  if (!is_plain() && structure_->levels > kMostLevels) return false;
  Meeting(question, hidden_bit, slots).find(*this, who, nearest);
  return !slots.overflowed();
}

bool Solid::hides_some() const { return structure_->hides_some; }

bool Solid::suits_blocks() const {
  return kind == Kind::shape ? shape->is_over_lanes() : structure_->levels <= kMostLevels;
}

/// Returns those points in `who` that a member holds; its boxes are asked first.
std::uint64_t Solid::member_holds(std::size_t index, const Columns3<double>& points, std::uint64_t who) const {
  const Solid& member = structure_->members[index];
  if (!member.is_plain()) return member.inside(points, who);
  const Reach& reach = structure_->member_reaches[index];
  if (is_bounded(reach.inside)) who = within(points, reach.inside, who);
  if (who == 0) return 0;
  const std::uint64_t in_doubt = is_bounded(reach.outside) ? within(points, reach.outside, who) : who;
  if (in_doubt == 0) return who;
  return (who & ~in_doubt) | member.shape->inside_block(points, in_doubt);
}

/// Returns those points in `who` that are inside of all members; own(member) tells which points need not be inside of
/// it.
template <class Own>
std::uint64_t Solid::inside_all_members(const Columns3<double>& points, std::uint64_t who, const Own& own) const {
  const Structure& structure = *structure_;
  Own own_of = own;
  const auto ask = [&](std::size_t i, std::uint64_t here, std::uint64_t left) {
    const std::uint64_t asked = here & ~own_of(structure.members[i]);
    return asked == 0 ? left : left & ~(asked & ~member_holds(i, points, asked));
  };
  if (structure.trees) return structure.trees->deciding.for_each_around(points, who, ask);
  for (std::size_t i = 0; i < structure.members.size() && who != 0; ++i) who = ask(i, who, who);
  return who;
}

/// Returns those points in `who` that are inside of any member, but for what own(member) tells.
template <class Own>
std::uint64_t Solid::inside_any_member(const Columns3<double>& points, std::uint64_t who, std::uint8_t hiding,
                                       const Own& own) const {
  const Structure& structure = *structure_;
  Own own_of = own;
  const auto ask = [&](std::size_t i, std::uint64_t here, std::uint64_t left) {
    const Solid& member = structure.members[i];
    const std::uint64_t asked = (member.hidden_from & hiding) != 0 ? 0 : here & ~own_of(member);
    return asked == 0 ? left : left & ~member_holds(i, points, asked);
  };
  if (structure.trees) return who & ~structure.trees->deciding.for_each_around(points, who, ask);
  std::uint64_t left = who;
  for (std::size_t i = 0; i < structure.members.size() && left != 0; ++i) left = ask(i, left, left);
  return who & ~left;
}

std::uint64_t Solid::inside(const Columns3<double>& points, std::uint64_t who) const {
  if (is_plain()) return shape->inside_block(points, who);
  const Structure& structure = *structure_;
  who = within(points, structure.reach.inside, who);
  if (who == 0) return 0;
  std::uint64_t in_doubt = within(points, structure.reach.outside, who);
  const std::uint64_t holding = who & ~in_doubt;
  for (const Solid& clip : structure.clips) {
    if (in_doubt == 0) break;
    in_doubt = clip.inside(points, in_doubt);
  }
  if (in_doubt == 0) return holding;
  const auto none = [](const Solid&) { return std::uint64_t{0}; };
  switch (kind) {
    case Kind::shape:
      return holding | shape->inside_block(points, in_doubt);
    case Kind::intersection:
      return holding | inside_all_members(points, in_doubt, none);
    case Kind::union_:
    case Kind::merge:
      break;
  }
  return holding | inside_any_member(points, in_doubt, 0, none);
}

}  // namespace firstlight::render
