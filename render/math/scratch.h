#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace firstlight::render {

/// Room for the numbers of a block, as long as it lives. As new: members that have a first value have it, and columns
/// hold whatever was there before.
///
/// Memory   Kept by the thread for whoever asks next: a block's numbers are more than an allocator hands out at once.
/// Threads  It stays with the thread that made it.
template <class T>
requires std::is_trivially_destructible_v<T>
class Scratch {
 public:
  Scratch() {
    auto& kept = kept_by_thread();
    if (kept.empty()) {
      own_ = std::make_unique_for_overwrite<T>();
    } else {
      own_ = std::move(kept.back());
      kept.pop_back();
      ::new (static_cast<void*>(own_.get())) T;
    }
  }
  ~Scratch() { kept_by_thread().push_back(std::move(own_)); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  T& operator*() const { return *own_; }
  T* operator->() const { return own_.get(); }

 private:
  static std::vector<std::unique_ptr<T>>& kept_by_thread() {
    thread_local std::vector<std::unique_ptr<T>> kept;
    return kept;
  }

  std::unique_ptr<T> own_;
};

}  // namespace firstlight::render
