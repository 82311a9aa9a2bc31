#include "priority/tile_source.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace firstlight::priority {
namespace {

constexpr Slot kTopSlot = kSlots - 1;

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

TileSource::TileSource(const render::PrimaryRays& rays, render::Film& film, render::PrimaryTiles tiles)
    : rays_(rays), film_(film), tiles_(std::move(tiles)) {
  for (std::uint32_t tile = 0; tile < tiles_.count(); ++tile) {
    const std::size_t owner = film.owner_of(tiles_.corner_of(tile));
    if (owner >= waiting_.size()) waiting_.resize(owner + 1);
    waiting_[owner].tiles.push_back({tile, tiles_.stride_of(tile), kTopSlot});
  }
  show_top_locked();
}

void TileSource::sort(const Scheme& scheme, std::uint64_t version) {
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

TileSource::Waiting* TileSource::next_locked(std::size_t worker) {
  Waiting* next = worker < waiting_.size() && waiting_[worker].first() != nullptr ? &waiting_[worker] : nullptr;
  for (Waiting& waiting : waiting_) {
    if (waiting.first() == nullptr) continue;
    if (next == nullptr || waiting.first()->precedes(*next->first())) next = &waiting;
  }
  return next;
}

bool TileSource::take(std::size_t worker, std::uint32_t& tile) {
  const std::lock_guard lock(mutex_);
  Waiting* const next = next_locked(worker);
  if (next == nullptr) return false;
  tile = next->tiles[next->begun++].number;
  show_top_locked();
  return true;
}

bool TileSource::next(std::size_t worker, Roots& roots) {
  roots.rays.clear();
  if (!take(worker, roots.number)) return false;
  tiles_.fill(roots.number, rays_, roots.rays);
  return true;
}

RootSource::Reached TileSource::lit(const Roots& roots) {
  for (const render::RayTask& task : roots.rays.tasks) film_.mark_lit(task.sample);
  for (const std::uint32_t sample : roots.rays.dark) film_.mark_lit(sample);
  // Release and acquire: whoever sees the last tile sees the film with all primary light.
  const bool is_coarse = roots.number < tiles_.coarse_count();
  Reached reached;
  reached.preview = is_coarse && coarse_lit_.fetch_add(1, std::memory_order_acq_rel) + 1 == tiles_.coarse_count();
  reached.first_image = lit_.fetch_add(1, std::memory_order_acq_rel) + 1 == tiles_.count();
  return reached;
}

void TileSource::show_top_locked() {
  int top = kNoSlot;
  for (const Waiting& waiting : waiting_) {
    if (const Tile* const tile = waiting.first(); tile != nullptr) top = std::max(top, static_cast<int>(tile->slot));
  }
  top_.store(top, std::memory_order_relaxed);
}

}  // namespace firstlight::priority
