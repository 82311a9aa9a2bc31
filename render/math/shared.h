#pragma once

#include "render/math/holder_count.h"

#include <utility>

namespace firstlight::render {

/// A value that its copies share until one of them is changed: a copy costs a pointer, and T() costs no memory at all.
///
/// Memory   One pointer, where a std::shared_ptr is two: scenes hold these values by the hundred thousand.
/// Threads  May be read from any thread; while one copy is changed, no other may be made or dropped.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(T value) : held_(new Box(std::move(value))) {}
  Shared(const Shared& other) noexcept : held_(other.held_) {
    if (held_) held_->holders.add();
  }
  Shared(Shared&& other) noexcept : held_(std::exchange(other.held_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Shared() {
    if (held_ && held_->holders.drop()) delete held_;
  }

  const T& operator*() const { return held_ ? value() : initial(); }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }

  /// Whether it is a T() that nothing has been changed in.
  bool is_initial() const { return held_ == nullptr; }
  /// Whether both are one value in memory.
  bool is_same(const Shared& other) const { return held_ == other.held_; }

  /// The value, to be changed; what other copies show stays as it is.
  T& change() {
    if (!held_) {
      held_ = new Box(T());
    } else if (!held_->holders.is_one()) {
      *this = Shared(value());
    }
    return value();
  }

 private:
  /// Ends as what it is, so that T may be unknown where a Shared is copied and dropped.
  struct Held {
    virtual ~Held() = default;
    HolderCount holders;
  };
  struct Box final : Held {
    explicit Box(T content) : value(std::move(content)) {}
    T value;
  };

  T& value() const { return static_cast<Box*>(held_)->value; }
  static const T& initial() {
    static const T value{};
    return value;
  }

  Held* held_ = nullptr;
};

}  // namespace firstlight::render
