#include "priority/schemes.h"

#include <array>

namespace firstlight::priority {
namespace {

constexpr std::array<std::string_view, render::kRayKinds> kWords{"primary", "reflection", "transmission", "shadow"};

/// By kind of ray, in the order that the user wants. Primary rays come first unless they are named: without them there
/// is nothing to see. Source   Yagel & Meeker 1997, section 4, "ray type"; without arguments in the order of the
/// paper's example.
class RayType final : public Scheme {
 public:
  explicit RayType(std::span<const std::uint32_t> ranks) {
    for (std::size_t kind = 0; kind < keys_.size(); ++kind)
      keys_[kind] = static_cast<Key>(keys_.size()) - 1 - ranks[kind];
  }

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = keys_[static_cast<std::size_t>(tasks[i].kind)];
  }
  Key key_count() const override { return static_cast<Key>(keys_.size()); }
  bool tells_pixels_apart() const override { return false; }

 private:
  std::array<Key, kWords.size()> keys_{};  ///< by RayKind
};

}  // namespace

SchemePtr make_ray_type(const SchemeInput&, SchemeText* arguments) {
  if (arguments == nullptr) return std::make_shared<RayType>(std::array<std::uint32_t, kWords.size()>{0, 1, 2, 3});
  Ranks ranks = read_ranks(*arguments, "a kind of ray", kWords);
  std::uint32_t& primary = ranks.of[static_cast<std::size_t>(render::RayKind::primary)];
  if (primary >= ranks.named) {
    for (std::uint32_t& rank : ranks.of) {
      if (rank < primary) ++rank;
    }
    primary = 0;
  }
  return std::make_shared<RayType>(ranks.of);
}

}  // namespace firstlight::priority
