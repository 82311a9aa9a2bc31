#include "render/shape/slots.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/slots.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#ifndef FIRSTLIGHT_RENDER_SHAPE_SLOTS
#define FIRSTLIGHT_RENDER_SHAPE_SLOTS
namespace firstlight::render {
namespace {

struct SlotInQuestion {
  const Column<double>* depth;
  std::uint64_t rays;  ///< of those that are asked for
  double number;
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

void nearest_in_slots(std::span<const SlotInQuestion> asked, std::uint64_t who, const DepthWindow& window,
                      NearestCrossings& nearest) {
  nearest.rays = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    const auto low = load<Lanes>(window.low, i);
    auto best = load<Lanes>(window.high, i);
    Lanes slot = -1.0;
    for (const SlotInQuestion& here : asked) {
      const std::uint64_t of_slot = here.rays >> i & kAllLanes;
      if (of_slot == 0) continue;
      const auto depth = load<Lanes>(*here.depth, i);
      const auto nearer = Lanes::mask_of(static_cast<unsigned>(of_slot)) & (depth > low) & (depth <= best);
      best = select(nearer, depth, best);
      slot = select(nearer, Lanes(here.number), slot);
    }
    store(best, nearest.depth, i);
    store(slot, nearest.slot, i);
    nearest.rays |= (bits(slot >= 0.0) & of_vector) << i;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(nearest_in_slots);

SlotSearch::SlotSearch(const Slots& slots, std::size_t first)
    : slots_(slots), first_(first), count_(slots.size() - first) {
  for (std::size_t i = 0; i < count_; ++i) {
    asked_[i] = static_cast<std::uint16_t>(i);
    rays_[i] = slots[first + i].rays;
  }
}

void SlotSearch::find(std::uint64_t who, const DepthWindow& window, NearestCrossings& nearest) {
  SlotInQuestion asked[Slots::kMost];
  std::size_t count = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint16_t offset = asked_[i];
    const std::uint64_t rays = rays_[offset] & who;
    if (rays == 0) continue;
    const std::size_t slot = first_ + offset;
    asked[count] = {&slots_[slot].depth, rays, static_cast<double>(slot)};
    asked_[count++] = offset;
  }
  count_ = count;
  HWY_DYNAMIC_DISPATCH(nearest_in_slots)(std::span(asked, count), who, window, nearest);
}

Slots& Slots::of_thread() {
  thread_local Slots slots;
  slots.clear();
  return slots;
}

Slot* Slots::add(const Shape& shape) {
  if (size_ == kMost) {
    overflowed_ = true;
    return nullptr;
  }
  if (size_ == slots_.size()) slots_.push_back(std::make_unique<Slot>());
  Slot& slot = *slots_[size_++];
  slot.begin(shape);
  return &slot;
}

bool SlotLists::append() {
  Slot* slot = slots_.add(shape_);
  if (slot == nullptr) return false;
  slot->has_faces = slot->has_places = with_details_;
  if (with_details_) slot->own_details();
  return true;
}

void Slots::drop_empty(std::size_t first) {
  std::size_t kept = first;
  for (std::size_t s = first; s < size_; ++s) {
    if (slots_[s]->rays == 0) continue;
    if (s != kept) std::swap(slots_[s], slots_[kept]);
    ++kept;
  }
  size_ = kept;
}

void Slots::turn_around(std::size_t first) {
  std::reverse(slots_.begin() + static_cast<std::ptrdiff_t>(first),
               slots_.begin() + static_cast<std::ptrdiff_t>(size_));
}

}  // namespace firstlight::render
#endif
