#pragma once

#include "priority/key.h"
#include "render/trace/ray_kind.h"

#include <array>
#include <bit>
#include <cstdint>

namespace firstlight::priority {

/// The list a waiting ray is kept in: one for each key and for radiance and shadow rays apart, so that a block holds
/// one kind of work. A larger slot leaves first; of one key, radiance leaves before shadows.
using Slot = std::uint32_t;
constexpr Slot kSlots = 2 * kBuckets;
/// Less than every slot.
constexpr int kNoSlot = -1;

constexpr Slot slot_of(Key key, render::RayKind kind) { return 2 * key + (kind == render::RayKind::shadow ? 0u : 1u); }
constexpr Key key_of(Slot slot) { return slot / 2; }

/// Which slots are looked at: all, or those of shadow rays.
enum class Among { all, shadows };

/// A set of slots whose largest member is found in a few instructions: a bitmap of bitmaps.
class SlotSet {
 public:
  void insert(Slot slot) {
    words_[slot / 64] |= bit(slot % 64);
    summary_[slot / 4096] |= bit(slot / 64 % 64);
  }
  void erase(Slot slot) {
    words_[slot / 64] &= ~bit(slot % 64);
    if (words_[slot / 64] == 0) summary_[slot / 4096] &= ~bit(slot / 64 % 64);
  }
  /// kNoSlot when there is none.
  int top(Among among = Among::all) const {
    const std::uint64_t mask = among == Among::all ? ~std::uint64_t{0} : kShadows;
    for (Slot s = kSummaries; s-- > 0;) {
      for (std::uint64_t left = summary_[s]; left != 0;) {
        const Slot bit_of_word = highest(left);
        const Slot word = 64 * s + bit_of_word;
        if ((words_[word] & mask) != 0) return static_cast<int>(64 * word + highest(words_[word] & mask));
        left &= ~bit(bit_of_word);
      }
    }
    return kNoSlot;
  }

 private:
  static constexpr Slot kSummaries = kSlots / 4096;
  static constexpr std::uint64_t kShadows = 0x5555555555555555u;  // slot_of() of shadow rays is even
  static_assert(kSlots % 4096 == 0);

  static constexpr std::uint64_t bit(Slot index) { return std::uint64_t{1} << index; }
  static constexpr Slot highest(std::uint64_t word) { return 63u - static_cast<Slot>(std::countl_zero(word)); }

  std::array<std::uint64_t, kSlots / 64> words_{};
  std::array<std::uint64_t, kSummaries> summary_{};  // bit w: words_[w] is not 0
};

}  // namespace firstlight::priority
