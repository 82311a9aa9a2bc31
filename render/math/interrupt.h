#pragma once

#include <atomic>
#include <utility>

namespace firstlight::render {

/// Lets what a thread computes end early when nobody wants it any more. While one lives, loops of its thread that may
/// take long ask asked() now and then, and leave with whatever they have when it is true: so what a computation returns
/// counts only if seen() is false after it.
///
/// Cost     of asked(): two loads. Loops whose rounds take less than some hundred nanoseconds ask once in many rounds.
/// Threads  The wish may come true from any thread; the rest belongs to the thread that made it.
class Interrupt {
 public:
  /// `wish` must outlive this and, once true, stay true.
  explicit Interrupt(const std::atomic<bool>& wish) : former_(std::exchange(state_, {&wish, false})) {}
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt() { state_ = former_; }

  /// Whether a loop of this thread shall leave with what it has.
  static bool asked() {
    if (state_.wish == nullptr || !state_.wish->load(std::memory_order_relaxed)) return false;
    state_.seen = true;
    return true;
  }
  /// Whether any loop of this thread was told so.
  static bool seen() { return state_.seen; }
  /// For loops of libraries, which may run on threads of their own; null: nothing can interrupt them.
  static const std::atomic<bool>* wish() { return state_.wish; }

 private:
  struct State {
    const std::atomic<bool>* wish = nullptr;
    bool seen = false;
  };

  static constinit thread_local State state_;
  const State former_;
};

inline constinit thread_local Interrupt::State Interrupt::state_;

}  // namespace firstlight::render
