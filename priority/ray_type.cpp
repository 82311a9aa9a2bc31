#include "priority/schemes.h"

namespace firstlight::priority {
namespace {

/// Primary rays first, then reflections, refractions and shadow feelers.
/// Source   Yagel & Meeker 1997, section 4, "ray type", in the order of the paper's example.
class RayType final : public Scheme {
 public:
  std::string_view name() const override { return "ray-type"; }

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    constexpr Key kLast = static_cast<Key>(render::RayKind::shadow);
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = kLast - static_cast<Key>(tasks[i].kind);
  }
};

}  // namespace

std::unique_ptr<const Scheme> make_ray_type(const SchemeInput&) { return std::make_unique<RayType>(); }

}  // namespace firstlight::priority
