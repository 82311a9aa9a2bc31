#include "priority/schemes.h"

#include <algorithm>

namespace firstlight::priority {
namespace {

/// The fewer reflections and refractions lie on the way to the eye, the earlier a ray leaves.
/// Source   Yagel & Meeker 1997, section 4, "level".
class Level final : public Scheme {
 public:
  explicit Level(Key last) : last_(last) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = last_ - std::min<Key>(tasks[i].level, last_);
  }
  Key key_count() const override { return last_ + 1; }
  bool tells_pixels_apart() const override { return false; }

 private:
  Key last_;  ///< level of the last rays
};

}  // namespace

SchemePtr make_level(const SchemeInput& input, SchemeText*) {
  constexpr int kLargest = 255;  // RayTask::level is a byte
  return std::make_shared<Level>(static_cast<Key>(std::clamp(input.scene.max_trace_level, 0, kLargest)));
}

}  // namespace firstlight::priority
