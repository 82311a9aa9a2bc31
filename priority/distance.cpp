#include "priority/log_scale.h"
#include "priority/schemes.h"

namespace firstlight::priority {
namespace {

constexpr LogScale kScale(-20, 30, 3);

/// The nearer the surface that a ray left lies to the eye, the earlier it leaves.
class Distance final : public Scheme {
 public:
  explicit Distance(const render::Vec3& eye) : eye_(eye) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      keys[i] = kScale.count() - 1 - kScale.of(static_cast<float>((tasks[i].origin - eye_).length()));
    }
  }
  Key key_count() const override { return kScale.count(); }
  bool tells_pixels_apart() const override { return false; }

 private:
  render::Vec3 eye_;
};

}  // namespace

SchemePtr make_distance(const SchemeInput& input, SchemeText*) { return std::make_shared<Distance>(input.scene.eye); }

}  // namespace firstlight::priority
