#pragma once

#include "render/math/ray_columns.h"
#include "render/shape/shape.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace firstlight::render {

/// Crossings of the rays of a block with one shape: at most one of each ray.
struct Slot {
  /// Facts that not all of its crossings have in common.
  struct Details {
    Column<double> face;
    std::array<Column<double>, 2> place;
  };

  Column<double> depth;
  std::uint64_t rays;  ///< bits of those that have a crossing here
  const Shape* shape;
  std::uint32_t part;
  std::uint32_t face;  ///< of all, unless each has its own
  bool has_faces;      ///< each crossing has its own face
  bool has_places;     ///< and place
  std::unique_ptr<Details> details;

  /// Begins without rays.
  void begin(const Shape& of) {
    rays = 0;
    shape = &of;
    part = 0;
    face = 0;
    has_faces = has_places = false;
  }
  Details& own_details() {
    if (!details) details = std::make_unique<Details>();
    return *details;
  }
  std::uint32_t face_of(std::size_t ray) const {
    return has_faces ? static_cast<std::uint32_t>(details->face[ray]) : face;
  }
  std::array<double, 2> place_of(std::size_t ray) const {
    if (!has_places) return {};
    return {details->place[0][ray], details->place[1][ray]};
  }
};

/// The crossings of a block of rays. Those of one ray, slot after slot, are its list of crossings as one ray alone has
/// it.
///
/// Memory   Half a kilobyte a slot, kept for the next block.
/// Threads  One has one.
class Slots {
 public:
  /// A block that needs more is met ray by ray.
  static constexpr std::size_t kMost = 1024;

  /// That of the calling thread, with no slots. What is asked with it must not ask for it again.
  static Slots& of_thread();

  std::size_t size() const { return size_; }
  Slot& operator[](std::size_t i) { return *slots_[i]; }
  const Slot& operator[](std::size_t i) const { return *slots_[i]; }
  /// Whether a slot was wanted for which there was no room.
  bool overflowed() const { return overflowed_; }

  /// One more, without rays; null if there is no room.
  Slot* add(const Shape& shape);
  /// From slot `first` on those that no ray has a crossing in are taken back.
  void drop_empty(std::size_t first);
  /// The order of the slots from `first` on is turned around.
  void turn_around(std::size_t first);
  /// Only the first `size` are kept.
  void cut(std::size_t size) { size_ = size; }
  void clear() {
    size_ = 0;
    overflowed_ = false;
  }

 private:
  std::vector<std::unique_ptr<Slot>> slots_;  // beyond size_: to be used again
  std::size_t size_ = 0;
  bool overflowed_ = false;
};

/// Appends to the crossings of the rays of a block with one shape, of one ray or another: each has a list of its own,
/// which goes through the slots from the first new one on.
class SlotLists {
 public:
  /// With details, or without for all.
  SlotLists(const Shape& shape, Slots& slots, bool with_details)
      : shape_(shape), slots_(slots), first_(slots.size()), with_details_(with_details) {
    count_.fill(0);
  }

  void add(std::size_t ray, double depth) {
    if (Slot* slot = next(ray)) slot->depth[ray] = depth;
  }
  void add(std::size_t ray, double depth, std::uint32_t face, const std::array<double, 2>& place) {
    Slot* slot = next(ray);
    if (slot == nullptr) return;
    slot->depth[ray] = depth;
    slot->details->face[ray] = face;
    slot->details->place[0][ray] = place[0];
    slot->details->place[1][ray] = place[1];
  }

 private:
  /// Null: there is no room.
  Slot* next(std::size_t ray) {
    const std::size_t at = first_ + count_[ray]++;
    if (at >= slots_.size() && !append()) return nullptr;
    Slot& slot = slots_[at];
    slot.rays |= std::uint64_t{1} << ray;
    return &slot;
  }
  bool append();

  const Shape& shape_;
  Slots& slots_;
  std::size_t first_;
  bool with_details_;
  std::array<std::uint16_t, kRaysAtOnce> count_;
};

/// The nearest crossing of each ray of a block.
struct NearestCrossings {
  std::uint64_t rays = 0;  ///< bits of those that have one
  Column<double> depth;
  Column<double> slot;  ///< its number

  std::size_t slot_of(std::size_t ray) const { return static_cast<std::size_t>(static_cast<std::int64_t>(slot[ray])); }
};

/// Looks for the nearest crossings of rays in slots, again and again.
class SlotSearch {
 public:
  /// In the slots from `first` on. Pre: they stay as they are meanwhile.
  SlotSearch(const Slots& slots, std::size_t first);

  /// Finds the nearest crossing of each ray in `who` within the window; the last of equal depths.
  /// Pre: all of `who` were asked for before, if any were.
  void find(std::uint64_t who, const DepthWindow& window, NearestCrossings& nearest);
  /// The ray's crossing in the slot is not found any more.
  void leave_out(std::size_t slot, std::size_t ray) { rays_[slot - first_] &= ~(std::uint64_t{1} << ray); }

 private:
  // Slots lie far apart in memory, so what is looked at in each of them lies here side by side.
  const Slots& slots_;
  std::size_t first_;
  std::size_t count_;                              ///< of asked_
  std::array<std::uint16_t, Slots::kMost> asked_;  ///< slots in which some ray may be found, counted from first_
  std::array<std::uint64_t, Slots::kMost> rays_;   ///< of each slot from first_ on
};

}  // namespace firstlight::render
