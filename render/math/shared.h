#pragma once

#include <memory>
#include <utility>

namespace firstlight::render {

/// A value that its copies share until one of them is changed: a copy costs a pointer, and T() costs no memory at all.
///
/// Threads  May be read from any thread; while one copy is changed, no other may be made or dropped.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(T value) : value_(std::make_shared<T>(std::move(value))) {}

  const T& operator*() const { return value_ ? *value_ : initial(); }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }

  /// Whether it is a T() that nothing has been changed in.
  bool is_initial() const { return value_ == nullptr; }
  /// Whether both are one value in memory.
  bool is_same(const Shared& other) const { return value_ == other.value_; }

  /// The value, to be changed; what other copies show stays as it is.
  T& change() {
    if (!value_) {
      value_ = std::make_shared<T>();
    } else if (value_.use_count() > 1) {
      value_ = std::make_shared<T>(*value_);
    }
    return *value_;
  }

 private:
  static const T& initial() {
    static const T value{};
    return value;
  }

  std::shared_ptr<T> value_;
};

}  // namespace firstlight::render
