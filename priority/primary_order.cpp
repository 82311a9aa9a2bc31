#include "priority/primary_order.h"

#include <algorithm>
#include <map>

namespace firstlight::priority {
namespace {

constexpr Slot kTopSlot = kSlots - 1;
constexpr std::size_t kPointsOfBatch = 256;
constexpr double kMiddleOfPixel = 0.5;

/// How much a primary ray adds to what the preview shows in its place, which is filled from a grid of twice the stride.
/// Measured with the sphere-flake in a room of mirrors: the area under the curve of the error is smallest.
float gain_of(int stride) {
  if (stride == 1) return 0.1f;
  return stride == 2 ? 0.25f : 1.0f;
}

Slot slot_of_tile(const Scheme& scheme, render::PrimaryBatch& rays, float gain, std::vector<Key>& keys) {
  for (render::RayTask& task : rays.tasks) task.radiance.set_weight(render::Rgb(gain));
  keys.resize(rays.tasks.size());
  scheme.keys(rays.tasks, keys);
  return slot_of(*std::ranges::max_element(keys), render::RayKind::primary);
}

}  // namespace

PrimaryOrder::PrimaryOrder(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
                           const render::AntialiasSettings* antialias)
    : rays_(context.scene, context.media, film.width(), film.height()),
      tiles_(film.width(), film.height(), antialias != nullptr ? render::base_offset(*antialias) : kMiddleOfPixel,
             order) {
  if (antialias != nullptr) {
    antialias_ = std::make_unique<render::Antialiasing>(*antialias, film);
  }
  waiting_.reserve(tiles_.count());
  for (std::uint32_t tile = 0; tile < tiles_.count(); ++tile) waiting_.push_back({tile, kTopSlot});
  show_top_locked();
}

void PrimaryOrder::sort(const Scheme& scheme, std::uint64_t version) {
  const std::lock_guard lock(mutex_);
  if (version <= version_) return;
  version_ = version;
  const auto begin = waiting_.begin() + static_cast<std::ptrdiff_t>(begun_);
  render::PrimaryBatch rays;
  std::vector<Key> keys;
  std::map<float, Slot> slots;  // by gain, for schemes to which all pixels are alike
  for (auto tile = begin; tile != waiting_.end(); ++tile) {
    if (tile->number < tiles_.coarse_count()) continue;
    const float gain = gain_of(tiles_.stride_of(tile->number));
    const auto known = slots.find(gain);
    if (known != slots.end()) {
      tile->slot = known->second;
      continue;
    }
    rays.clear();
    tiles_.fill(tile->number, rays_, rays);
    if (rays.tasks.empty()) continue;
    tile->slot = slot_of_tile(scheme, rays, gain, keys);
    if (!scheme.tells_pixels_apart()) slots[gain] = tile->slot;
  }
  std::sort(begin, waiting_.end(),
            [](const Tile& a, const Tile& b) { return a.slot != b.slot ? a.slot > b.slot : a.number < b.number; });
  show_top_locked();
}

bool PrimaryOrder::next(Batch& batch) {
  batch.rays.clear();
  std::uint32_t tile = 0;
  {
    const std::lock_guard lock(mutex_);
    if (begun_ == waiting_.size()) {
      const auto points = points_.first(std::min(points_.size(), kPointsOfBatch));
      if (points.empty()) return false;
      points_ = points_.subspan(points.size());
      show_top_locked();
      batch.is_tile = batch.is_coarse = false;
      for (const auto& point : points) rays_.append(point.x, point.y, point.sample, batch.rays);
      return true;
    }
    tile = waiting_[begun_++].number;
    show_top_locked();
  }
  batch.is_tile = true;
  batch.is_coarse = tile < tiles_.coarse_count();
  tiles_.fill(tile, rays_, batch.rays);
  return true;
}

bool PrimaryOrder::refill() {
  const std::lock_guard lock(mutex_);
  if (antialias_ == nullptr) return false;
  points_ = antialias_->next();
  show_top_locked();
  return !points_.empty();
}

void PrimaryOrder::show_top_locked() {
  const int top = begun_ < waiting_.size() ? static_cast<int>(waiting_[begun_].slot)
                  : points_.empty()        ? kNoSlot
                                           : static_cast<int>(kTopSlot);
  top_.store(top, std::memory_order_relaxed);
}

}  // namespace firstlight::priority
