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

/// Asks a scheme for the slots of tiles. The rays themselves are not made: no scheme can tell more of them than their
/// samples.
class TileSlots {
 public:
  TileSlots(const Scheme& scheme, const render::PrimaryTiles& tiles, const render::RayTask& ray)
      : scheme_(scheme), tiles_(tiles), ray_(ray) {}

  Slot of(std::uint32_t tile) {
    const float gain = gain_of(tiles_.stride_of(tile));
    const auto known = by_gain_.find(gain);
    if (known != by_gain_.end()) return known->second;
    samples_.clear();
    tiles_.append_samples(tile, samples_);
    if (samples_.empty()) return kTopSlot;
    if (gain != gain_) {
      gain_ = gain;
      ray_.set_weight(render::Rgb(gain), 1.0f);
      rays_.clear();
    }
    if (rays_.size() < samples_.size()) rays_.resize(samples_.size(), ray_);
    for (std::size_t i = 0; i < samples_.size(); ++i) rays_[i].sample = samples_[i];
    keys_.resize(samples_.size());
    scheme_.keys(std::span(rays_).first(samples_.size()), keys_);
    const Slot slot = slot_of(*std::ranges::max_element(keys_), render::RayKind::primary);
    if (!scheme_.tells_pixels_apart()) by_gain_[gain] = slot;
    return slot;
  }

 private:
  const Scheme& scheme_;
  const render::PrimaryTiles& tiles_;
  render::RayTask ray_;
  std::vector<std::uint32_t> samples_;
  float gain_ = 0.0f;
  std::vector<render::RayTask> rays_;  // of gain_
  std::vector<Key> keys_;
  std::map<float, Slot> by_gain_;  // for schemes to which all pixels are alike
};

}  // namespace

PrimaryOrder::PrimaryOrder(const render::TraceContext& context, render::Film& film, render::PrimaryTiles::Order order,
                           const render::AntialiasSettings* antialias)
    : rays_(context.scene, context.media, {context.camera(), film.width(), film.height()}),
      tiles_(film.width(), film.height(), antialias != nullptr ? render::base_offset(*antialias) : kMiddleOfPixel,
             order) {
  if (antialias != nullptr) {
    antialias_ = std::make_unique<render::Antialiasing>(*antialias, film);
  }
  for (std::uint32_t tile = 0; tile < tiles_.count(); ++tile) {
    const std::size_t owner = film.owner_of(tiles_.corner_of(tile));
    if (owner >= waiting_.size()) waiting_.resize(owner + 1);
    waiting_[owner].tiles.push_back({tile, tiles_.stride_of(tile), kTopSlot});
  }
  show_top_locked();
}

void PrimaryOrder::sort(const Scheme& scheme, std::uint64_t version) {
  const std::lock_guard lock(mutex_);
  if (version <= version_) return;
  version_ = version;
  TileSlots slots(scheme, tiles_, rays_.unmade());
  for (auto& [tiles, begun] : waiting_) {
    const auto begin = tiles.begin() + static_cast<std::ptrdiff_t>(begun);
    for (auto tile = begin; tile != tiles.end(); ++tile) {
      if (tile->number >= tiles_.coarse_count()) tile->slot = slots.of(tile->number);
    }
    // Tiles are numbered from coarse to fine.
    std::sort(begin, tiles.end(),
              [](const Tile& a, const Tile& b) { return a.slot != b.slot ? a.slot > b.slot : a.number < b.number; });
  }
  show_top_locked();
}

PrimaryOrder::Waiting* PrimaryOrder::next_locked(std::size_t worker) {
  Waiting* next = worker < waiting_.size() && waiting_[worker].first() != nullptr ? &waiting_[worker] : nullptr;
  for (Waiting& waiting : waiting_) {
    if (waiting.first() == nullptr) continue;
    if (next == nullptr || waiting.first()->precedes(*next->first())) next = &waiting;
  }
  return next;
}

bool PrimaryOrder::next(std::size_t worker, Batch& batch) {
  batch.rays.clear();
  std::uint32_t tile = 0;
  {
    const std::lock_guard lock(mutex_);
    Waiting* const next = next_locked(worker);
    if (next == nullptr) {
      const auto points = points_.first(std::min(points_.size(), kPointsOfBatch));
      if (points.empty()) return false;
      points_ = points_.subspan(points.size());
      show_top_locked();
      batch.is_tile = batch.is_coarse = false;
      std::vector<render::PrimaryPlace> places;
      places.reserve(points.size());
      for (const auto& point : points) places.push_back({point.x, point.y, point.sample});
      rays_.append(places, batch.rays);
      return true;
    }
    tile = next->tiles[next->begun++].number;
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
  int top = points_.empty() ? kNoSlot : static_cast<int>(kTopSlot);
  for (const Waiting& waiting : waiting_) {
    if (const Tile* const tile = waiting.first(); tile != nullptr) top = std::max(top, static_cast<int>(tile->slot));
  }
  top_.store(top, std::memory_order_relaxed);
}

}  // namespace firstlight::priority
