#pragma once

#include "priority/scheme.h"

#include <algorithm>
#include <utility>

namespace firstlight::priority {

/// Orders shadow feelers by their light: key_of(task, index into Scene::lights, light at stake) gives keys below
/// `count`. The feelers of one record leave together, by the best of their keys. Other rays leave before all feelers.
template <class KeyOf>
class FeelerScheme final : public Scheme {
 public:
  FeelerScheme(Key count, KeyOf key_of) : count_(count), key_of_(std::move(key_of)) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      keys[i] = count_;
      if (tasks[i].kind != render::RayKind::shadow) continue;
      Key best = 0;
      tasks[i].for_each_feeler([&](std::uint32_t light, const render::PackedRgb& at_stake) {
        best = std::max(best, key_of_(tasks[i], light, at_stake));
      });
      keys[i] = best;
    }
  }
  Key key_count() const override { return count_ + 1; }
  bool tells_pixels_apart() const override { return false; }

 private:
  Key count_;
  KeyOf key_of_;
};

}  // namespace firstlight::priority
