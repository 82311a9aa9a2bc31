#pragma once

#include "priority/scheme.h"

#include <utility>
#include <vector>

namespace firstlight::priority {

/// By the surface that a ray left: a key for each group of the scene's objects.
class ObjectScheme final : public Scheme {
 public:
  /// `by_group`: keys below `count`. Primary rays, which left none, come first: without them there
  /// is nothing to see.
  ObjectScheme(std::vector<Key> by_group, Key count) : by_group_(std::move(by_group)), count_(count) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      keys[i] = tasks[i].object < by_group_.size() ? by_group_[tasks[i].object] : count_ - 1;
    }
  }
  Key key_count() const override { return count_; }
  bool tells_pixels_apart() const override { return false; }

 private:
  std::vector<Key> by_group_;
  Key count_;
};

}  // namespace firstlight::priority
