#include "priority/round_source.h"

#include <algorithm>
#include <array>

namespace firstlight::priority {
namespace {

constexpr std::size_t kPointsOfRoots = 256;
constexpr int kTopSlot = kSlots - 1;

}  // namespace

std::span<const render::SamplePoint> RoundSource::take() {
  const std::lock_guard lock(mutex_);
  const auto points = points_.first(std::min(points_.size(), kPointsOfRoots));
  points_ = points_.subspan(points.size());
  if (points_.empty()) top_.store(kNoSlot, std::memory_order_relaxed);
  return points;
}

bool RoundSource::next(std::size_t /*worker*/, Roots& roots) {
  roots.rays.clear();
  const auto points = take();
  std::array<render::PrimaryPlace, kPointsOfRoots> places;
  std::ranges::transform(points, places.begin(), [](const render::SamplePoint& point) {
    return render::PrimaryPlace{point.x, point.y, point.sample, point.number};
  });
  rays_.append(std::span(places).first(points.size()), roots.rays);
  return !points.empty();
}

bool RoundSource::refill() {
  const std::lock_guard lock(mutex_);
  points_ = rounds_.next();
  top_.store(points_.empty() ? kNoSlot : kTopSlot, std::memory_order_relaxed);
  return !points_.empty();
}

}  // namespace firstlight::priority
