#include "priority/schemes.h"

namespace firstlight::priority {
namespace {

/// The fewer reflections and refractions lie on the way to the eye, the earlier a ray leaves.
/// Source   Yagel & Meeker 1997, section 4, "level".
class Level final : public Scheme {
 public:
  std::string_view name() const override { return "level"; }

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    constexpr Key kTop = 255;  // RayTask::level is a byte
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = kTop - tasks[i].level;
  }
};

}  // namespace

std::unique_ptr<const Scheme> make_level(const SchemeInput&) { return std::make_unique<Level>(); }

}  // namespace firstlight::priority
