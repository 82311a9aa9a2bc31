#pragma once

#include "priority/key.h"

namespace firstlight::priority {

/// Keys in which a first key decides and a second one orders what is equal by the first. Where both together would be
/// more than there are keys, the second becomes coarser.
class StackedKeys {
 public:
  /// Pre: counts of at least 1 and at most kBuckets.
  StackedKeys(Key first_count, Key second_count)
      : share_(kBuckets / first_count < second_count ? kBuckets / first_count : second_count),
        second_count_(second_count),
        count_(first_count * share_) {}

  Key count() const { return count_; }
  Key of(Key first, Key second) const {
    return first * share_ + (share_ == second_count_ ? second : second * share_ / second_count_);
  }

 private:
  Key share_;  ///< keys for each value of the first
  Key second_count_;
  Key count_;
};

}  // namespace firstlight::priority
