#include "priority/frame.h"

#include <utility>

namespace firstlight::priority {
namespace {

constexpr std::chrono::milliseconds kProgressEvery{100};
constexpr std::chrono::milliseconds kKeyChangeEvery{250};

}  // namespace

Frame::Frame(const render::TraceContext& context, render::Film& film, const TraceOptions& options)
    : context_(context),
      film_(film),
      tiles_(context.scene, context.media, film.width(), film.height()),
      alone_(options.threads == 1),
      stop_(options.stop),
      workers_(options.threads) {}

std::optional<std::uint32_t> Frame::next_tile() {
  // The look before keeps the counter from running away when many ask at the end.
  if (next_tile_.load(std::memory_order_relaxed) >= tiles_.count()) return std::nullopt;
  const std::uint32_t tile = next_tile_.fetch_add(1, std::memory_order_relaxed);
  return tile < tiles_.count() ? std::optional(tile) : std::nullopt;
}

void Frame::tile_is_lit() {
  // Release and acquire: whoever sees the last tile sees the film with all primary light.
  if (tiles_lit_.fetch_add(1, std::memory_order_acq_rel) + 1 < tiles_.count()) return;
  const std::lock_guard lock(mutex_);
  first_image_ = Clock::now();
  first_image_is_news_ = true;
  event_.notify_all();
}

void Frame::popped(Key key) {
  if (key_.load(std::memory_order_relaxed) == key) return;
  key_.store(key, std::memory_order_relaxed);
  if (!wants_key_change_.load(std::memory_order_relaxed) || !wants_key_change_.exchange(false)) return;
  const std::lock_guard lock(mutex_);
  key_changed_ = true;
  event_.notify_all();
}

void Frame::fail(const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (error_.empty()) error_ = why;
  failed_.store(true, std::memory_order_relaxed);
}

void Frame::leave() {
  const std::lock_guard lock(mutex_);
  if (--workers_ == 0) event_.notify_all();
}

void Frame::watch(Observer* observer, const RayQueue* queue) {
  Clock::time_point next_progress = begin_ + kProgressEvery;
  Clock::time_point next_key_change = begin_;
  std::unique_lock lock(mutex_);
  while (workers_ > 0 || first_image_is_news_) {
    if (observer == nullptr) {
      event_.wait(lock, [this] { return workers_ == 0; });
      return;
    }
    if (!key_changed_ && Clock::now() >= next_key_change) wants_key_change_.store(true, std::memory_order_relaxed);
    event_.wait_until(lock, next_progress, [this] { return workers_ == 0 || first_image_is_news_ || key_changed_; });
    const bool first_image = std::exchange(first_image_is_news_, false);
    const bool key_change = std::exchange(key_changed_, false);
    lock.unlock();
    const Progress now = progress(queue);
    if (first_image) observer->first_image(now);
    if (key_change) {
      observer->key_changed(now);
      next_key_change = Clock::now() + kKeyChangeEvery;
    }
    if (Clock::now() >= next_progress) {
      observer->progress(now);
      next_progress = Clock::now() + kProgressEvery;
    }
    lock.lock();
  }
}

Progress Frame::progress(const RayQueue* queue) const {
  Progress progress;
  progress.tiles_done = tiles_lit_.load(std::memory_order_relaxed);
  progress.tiles = tiles_.count();
  progress.rays_traced = rays_traced_.load(std::memory_order_relaxed);
  progress.rays_waiting = queue != nullptr ? queue->waiting() : 0;
  progress.key = key_.load(std::memory_order_relaxed);
  progress.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  return progress;
}

std::string Frame::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

std::optional<std::chrono::steady_clock::time_point> Frame::first_image() const {
  const std::lock_guard lock(mutex_);
  return first_image_;
}

}  // namespace firstlight::priority
