#include "priority/blocked_shares.h"

#include <algorithm>
#include <array>

namespace firstlight::priority {
namespace {

using render::FixedRgb;
using render::PackedRgb;
using render::RayTask;

constexpr float kBefore = 0.4f;  ///< share of blocked feelers where nothing is known
constexpr float kTrust = 1.0f;   ///< feelers that it takes to believe something else

double size_of(const FixedRgb& light) { return FixedRgb::to_double(light.max_magnitude()); }

}  // namespace

BlockedShares::BlockedShares(const Cells& cells, std::size_t lights)
    : lights_(std::clamp<std::size_t>(lights, 1, kMostLights)),
      seen_(cells.count() * kDepths * lights_),
      shares_(seen_.size()) {
  for (std::atomic<float>& share : shares_) share.store(kBefore, std::memory_order_relaxed);
}

void BlockedShares::learn(std::size_t place, float blocked) {
  seen_[place].add(blocked, 1.0f);
  shares_[place].store(seen_[place].estimate(kBefore, kTrust), std::memory_order_relaxed);
}

void BlockedShares::learn(std::size_t cell, const RayTask& feelers, const FixedRgb& light) {
  const std::size_t begin = base(cell, feelers);
  std::array<FixedRgb, RayTask::kMostFeelers> at_stake;
  std::array<std::size_t, RayTask::kMostFeelers> places{};
  std::size_t count = 0;
  double all = 0.0;
  feelers.for_each_feeler([&](std::uint32_t index, const PackedRgb& packed) {
    places[count] = begin + place_of(index);
    at_stake[count] = FixedRgb::from(packed);
    all += size_of(at_stake[count++]);
  });
  // Which of them were blocked: their light has been taken back to the last bit.
  for (unsigned set = 0; set < (1u << count); ++set) {
    FixedRgb taken;
    for (std::size_t i = 0; i < count; ++i) {
      if ((set >> i & 1u) != 0) taken -= at_stake[i];
    }
    if (taken != light) continue;
    for (std::size_t i = 0; i < count; ++i) learn(places[i], static_cast<float>(set >> i & 1u));
    return;
  }
  // Something transparent was in the way: nobody knows of which.
  const float share = all > 0.0 ? static_cast<float>(std::min(size_of(light) / all, 1.0)) : 0.0f;
  for (std::size_t i = 0; i < count; ++i) learn(places[i], share);
}

}  // namespace firstlight::priority
