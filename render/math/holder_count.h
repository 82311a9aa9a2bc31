#pragma once

#include <atomic>
#include <cstddef>

#if __has_include(<sys/single_threaded.h>)
#include <sys/single_threaded.h>
#endif

namespace firstlight::render {

/// How many pointers hold a thing; begins with one.
///
/// Threads  Holders may come and go in any thread. While a process has but one, as while it reads a scene, counting
///          costs no locked instruction.
class HolderCount {
 public:
  void add() noexcept {
    if (is_alone()) {
      count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    } else {
      count_.fetch_add(1, std::memory_order_relaxed);
    }
  }
  /// True: that was the last one.
  bool drop() noexcept {
    if (!is_alone()) return count_.fetch_sub(1, std::memory_order_acq_rel) == 1;
    const std::size_t left = count_.load(std::memory_order_relaxed) - 1;
    count_.store(left, std::memory_order_relaxed);
    return left == 0;
  }
  bool is_one() const noexcept { return count_.load(std::memory_order_acquire) == 1; }

 private:
  static bool is_alone() noexcept {
#if __has_include(<sys/single_threaded.h>)
    return __libc_single_threaded != 0;
#else
    return false;
#endif
  }

  std::atomic<std::size_t> count_ = 1;
};

}  // namespace firstlight::render
