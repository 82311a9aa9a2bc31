#include "render/accel/accel.h"

#include "render/accel/leaves.h"

namespace firstlight::render {

struct Accel::Impl {
  explicit Impl(const Scene& scene) : leaves(scene) {}
  Leaves leaves;
};

Accel::Accel(const Scene& scene) : impl_(std::make_unique<Impl>(scene)) {}
Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;
Accel& Accel::operator=(Accel&&) noexcept = default;

void Accel::closest(std::span<const RayQuery> queries, std::span<Hit> hits) const {
  find_closest(impl_->leaves, queries, hits);
}

void Accel::occluded(std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) const {
  find_occluded(impl_->leaves, queries, blocked);
}

}  // namespace firstlight::render
