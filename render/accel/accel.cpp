#include "render/accel/accel.h"

#include "render/accel/leaves.h"
#include "render/accel/light_buffer.h"

#include <algorithm>

namespace firstlight::render {
namespace {

/// Calls visit(index of the first query, block) for kRaysAtOnce queries after the other.
template <class Visit>
void for_each_block(std::span<const RayQuery> queries, const Visit& visit) {
  RayBlock block;
  for (std::size_t first = 0; first < queries.size(); first += kRaysAtOnce) {
    block.size = std::min(kRaysAtOnce, queries.size() - first);
    for (std::size_t i = 0; i < block.size; ++i) {
      const RayQuery& query = queries[first + i];
      block.origin.set(i, query.ray.origin);
      block.direction.set(i, query.ray.direction);
      block.min_depth[i] = query.min_depth;
      block.max_depth[i] = query.max_depth;
      block.hidden_bit[i] = query.hidden_bit;
    }
    visit(first, block);
  }
}

}  // namespace

struct Accel::Impl {
  Impl(const Scene& scene, Foresight foresight)
      : leaves(scene),
        light_buffer(leaves, foresight == Foresight::some ? std::span(scene.lights) : std::span<const Light>()) {}
  Leaves leaves;
  LightBuffer light_buffer;
};

Accel::Accel(const Scene& scene, Foresight foresight) : impl_(std::make_unique<Impl>(scene, foresight)) {}
Accel::~Accel() = default;
Accel::Accel(Accel&&) noexcept = default;
Accel& Accel::operator=(Accel&&) noexcept = default;

void Accel::closest(const RayBlock& rays, std::span<Hit> hits) const { find_closest(impl_->leaves, rays, hits); }

std::uint64_t Accel::occluded(const RayBlock& rays) const { return find_occluded(impl_->leaves, rays); }

void Accel::foresee(const FeelerStarts& starts, std::size_t first, std::span<const Light> lights,
                    std::span<Foreseen> foreseen) const {
  if (impl_->light_buffer.known()) {
    find_foreseen(impl_->leaves, impl_->light_buffer, starts, first, lights, foreseen);
  } else {
    std::ranges::fill(foreseen, Foreseen());
  }
}

void Accel::closest(std::span<const RayQuery> queries, std::span<Hit> hits) const {
  for_each_block(queries,
                 [&](std::size_t first, const RayBlock& block) { closest(block, hits.subspan(first, block.size)); });
}

void Accel::occluded(std::span<const RayQuery> queries, std::span<std::uint8_t> blocked) const {
  for_each_block(queries, [&](std::size_t first, const RayBlock& block) {
    const std::uint64_t bits = occluded(block);
    for (std::size_t i = 0; i < block.size; ++i) blocked[first + i] = static_cast<std::uint8_t>(bits >> i & 1u);
  });
}

}  // namespace firstlight::render
