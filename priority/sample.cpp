#include "priority/schemes.h"

namespace firstlight::priority {
namespace {

/// The first sample of each pixel before those that anti-aliasing adds.
/// Source   Yagel & Meeker 1997, section 4, further criteria: sample order, for incremental supersampling.
class Sample final : public Scheme {
 public:
  explicit Sample(std::uint32_t pixels) : pixels_(pixels) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = tasks[i].sample < pixels_ ? 1 : 0;
  }
  Key key_count() const override { return 2; }
  bool tells_pixels_apart() const override { return false; }

 private:
  std::uint32_t pixels_;
};

}  // namespace

SchemePtr make_sample(const SchemeInput& input, SchemeText*) {
  return std::make_shared<Sample>(static_cast<std::uint32_t>(input.width) * static_cast<std::uint32_t>(input.height));
}

}  // namespace firstlight::priority
