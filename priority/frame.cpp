#include "priority/frame.h"

#include "priority/steering.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace firstlight::priority {
namespace {

constexpr std::chrono::milliseconds kProgressEvery{100};
constexpr std::chrono::milliseconds kLookEvery{10};  // at aims, and at what the user asks for
constexpr std::chrono::milliseconds kKeyChangeEvery{250};

/// How many low bits a sum of `most` over all samples has to leave out to stay within 64 bits; nearly always none.
int bits_left_out(std::int64_t most, std::uint64_t samples) {
  constexpr int kRoom = 62;
  const int bits = std::bit_width(static_cast<std::uint64_t>(most)) + std::bit_width(samples);
  return std::max(0, bits - kRoom);
}

/// Rounded up, so that a bound stays a bound.
std::int64_t without_low_bits(std::int64_t steps, int bits) { return (steps + (std::int64_t{1} << bits) - 1) >> bits; }

render::RayTask primary_task() {
  render::RayTask task;
  task.set_weight(render::Rgb(1.0f), 1.0f);
  return task;
}

}  // namespace

Frame::Frame(const render::TraceContext& context, std::span<const Pass> passes, const TraceOptions& options)
    : context_(context),
      surfaces_(render::make_surfaces(context.scene)),
      options_(options),
      bound_(context.scene, context.camera(), *surfaces_, context.with_alpha),
      most_of_root_(bound_.at_stake(primary_task())),
      next_checkpoint_(options.checkpoint_rays),
      workers_(options.threads) {
  std::uint64_t counted = 0;
  for (const auto& [source, sink] : passes) {
    const auto same = std::ranges::find(stages_, sink, &Stage::sink);
    if (same != stages_.end()) {
      stages_.push_back({source, sink, same->is_counted});
      continue;
    }
    sink->expect(most_of_root_);
    const std::optional<double> told = sink->outstanding();
    stages_.push_back({source, sink, /*is_counted=*/!told});
    samples_ += sink->samples();
    if (told) {
      asked_.push_back(sink);
      remaining_asked_ = remaining_asked_ + *told;
    } else {
      counted += sink->samples();
    }
  }
  left_out_ = bits_left_out(most_of_root_, counted);
  remaining_ = without_low_bits(most_of_root_, left_out_) * static_cast<std::int64_t>(counted);
}

bool Frame::refill() {
  while (!roots().refill()) {
    const std::size_t next = stage_.load(std::memory_order_relaxed) + 1;
    if (next == stages_.size()) return false;
    stage_.store(next, std::memory_order_relaxed);
    if (roots().top() != kNoSlot) return true;
  }
  return true;
}

bool Frame::asked_to_stop() const {
  return (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) ||
         (options_.steering != nullptr && options_.steering->stopped());
}

bool Frame::paused() const { return options_.steering != nullptr && options_.steering->paused(); }

void Frame::lit(const Roots& roots) {
  const RootSource::Reached reached = stage().source->lit(roots);
  if (!reached.preview && !reached.first_image) return;
  const std::lock_guard lock(mutex_);
  if (reached.preview) {
    preview_ = Clock::now();
    news_.preview = true;
  }
  if (reached.first_image) {
    first_image_ = Clock::now();
    news_.first_image = true;
  }
  event_.notify_all();
}

void Frame::add(const render::Tracer& tracer, Tally& tally) {
  constexpr int kBatchesOfReport = 8;
  const Stage& now = stage();
  if (!tracer.clearness().empty()) now.sink->add_clearness(tracer.clearness());
  now.sink->add(tracer.light());
  if (now.is_counted) {
    for (const render::Contribution& contribution : tracer.light()) tally.change += contribution.outstanding;
  }
  if (++tally.batches == kBatchesOfReport) report(tracer.counts(), tally);
}

void Frame::add_rest(const render::PrimaryBatch& rays, Tally& tally) {
  if (rays.dark.empty() && rays.shared.empty()) return;
  std::vector<render::Clearness> dark;
  for (const std::uint32_t sample : rays.dark) dark.push_back({sample, render::FixedRgb::to_fixed(1.0f)});
  std::vector<render::Contribution> nothing;
  nothing.reserve(rays.dark.size() + rays.shared.size());
  for (const std::uint32_t sample : rays.dark) nothing.push_back({sample, {}, -most_of_root_});
  for (const auto& [ray, count] : rays.shared) {
    nothing.push_back({ray.sample, {}, bound_.at_stake(ray) * count - most_of_root_});
  }
  const Stage& now = stage();
  now.sink->add_clearness(dark);
  now.sink->add(nothing);
  if (!now.is_counted) return;
  for (const render::Contribution& contribution : nothing) tally.change += contribution.outstanding;
}

void Frame::report(const render::RayCounts& counts, Tally& tally) {
  const render::RayCounts more = counts - tally.reported;
  remaining_.fetch_add(without_low_bits(tally.change, left_out_), std::memory_order_relaxed);
  tally = {counts, 0, 0};
  const auto add = [](std::atomic<std::uint64_t>& sum, std::uint64_t n) {
    if (n > 0) sum.fetch_add(n, std::memory_order_relaxed);
  };
  for (std::size_t kind = 0; kind < traced_.size(); ++kind) add(traced_[kind], more.by_kind[kind]);
  add(clear_, more.clear);
  add(blocked_, more.blocked);
  if (options_.checkpoint_rays == 0 || traced().traced() < next_checkpoint_.load(std::memory_order_relaxed)) {
    return;
  }
  if (checkpoint_due_.exchange(true)) return;
  const std::lock_guard lock(mutex_);
  event_.notify_all();
}

render::RayCounts Frame::traced() const {
  render::RayCounts counts;
  for (std::size_t kind = 0; kind < traced_.size(); ++kind) {
    counts.by_kind[kind] = traced_[kind].load(std::memory_order_relaxed);
  }
  counts.clear = clear_.load(std::memory_order_relaxed);
  counts.blocked = blocked_.load(std::memory_order_relaxed);
  return counts;
}

void Frame::popped(Key key) {
  if (key_.load(std::memory_order_relaxed) == key) return;
  key_.store(key, std::memory_order_relaxed);
  if (!wants_key_change_.load(std::memory_order_relaxed) || !wants_key_change_.exchange(false)) return;
  const std::lock_guard lock(mutex_);
  news_.key_changed = true;
  event_.notify_all();
}

void Frame::fail(const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (error_.empty()) error_ = why;
  end_ = End::failed;
  stopped_.store(true, std::memory_order_relaxed);
  go_on_.notify_all();
  if (options_.steering != nullptr) options_.steering->stop();  // wakes those who pause
}

void Frame::leave() {
  const std::lock_guard lock(mutex_);
  --workers_;
  event_.notify_all();
}

void Frame::rest() {
  if (paused()) options_.steering->wait_while_paused();
  std::unique_lock lock(mutex_);
  if (!checkpoint_due_) return;
  ++resting_;
  event_.notify_all();
  go_on_.wait(lock, [this] { return !checkpoint_due_ || stopped_; });
  --resting_;
}

bool Frame::all_rest(const RayQueue& queue) const { return resting_ + queue.idle() >= workers_; }

void Frame::hold_checkpoint(const Progress& progress, std::unique_lock<std::mutex>& lock) {
  const Clock::time_point begin = Clock::now();
  lock.unlock();
  options_.observer->checkpoint(progress);
  lock.lock();
  rested_ += Clock::now() - begin;
  const std::uint64_t every = options_.checkpoint_rays;
  next_checkpoint_ = (progress.traced.traced() / every + 1) * every;
  checkpoint_due_ = false;
  go_on_.notify_all();
}

void Frame::end_with(End end) {
  const std::lock_guard lock(mutex_);
  if (end_ == End::complete) end_ = end;
  stopped_.store(true, std::memory_order_relaxed);
  go_on_.notify_all();
}

void Frame::stop_where_aims_are_reached() {
  if (options_.stop_at_error > 0.0 && remaining() <= options_.stop_at_error) end_with(End::error_reached);
  if (options_.stop_after > 0.0 && seconds() >= options_.stop_after) end_with(End::time_over);
  if (!asked_to_stop()) return;
  end_with(End::stopped);
  if (options_.steering != nullptr) options_.steering->stop();  // wakes those who pause
}

std::chrono::duration<double> Frame::look_after() const {
  const std::chrono::duration<double> usual = kLookEvery;
  if (options_.stop_after <= 0.0) return usual;
  const std::chrono::duration<double> past = Clock::now() - begin_ - rested_;
  return std::clamp(std::chrono::duration<double>(options_.stop_after) - past, std::chrono::duration<double>(0.0),
                    usual);
}

void Frame::watch(const RayQueue& queue, const BlockPool& pool) {
  static Observer nobody;
  Observer& observer = options_.observer != nullptr ? *options_.observer : nobody;
  Clock::time_point next_progress = begin_ + kProgressEvery;
  Clock::time_point next_key_change = begin_;
  std::unique_lock lock(mutex_);
  while (workers_ > 0 || news_.any()) {
    if (!news_.key_changed && Clock::now() >= next_key_change) wants_key_change_.store(true, std::memory_order_relaxed);
    const Clock::time_point before = Clock::now();
    event_.wait_for(lock, kLookEvery,
                    [&] { return workers_ == 0 || news_.any() || (checkpoint_due_ && all_rest(queue)); });
    if (paused()) rested_ += Clock::now() - before;
    if (checkpoint_due_ && workers_ > 0 && all_rest(queue)) {
      const Progress now = progress(queue, pool);
      hold_checkpoint(now, lock);
    }
    const News news = std::exchange(news_, {});
    lock.unlock();
    if (Clock::now() >= next_progress) ask_sinks();
    stop_where_aims_are_reached();
    const Progress now = progress(queue, pool);
    if (news.preview) observer.preview(now);
    if (news.first_image) observer.first_image(now);
    if (news.key_changed) {
      observer.key_changed(now);
      next_key_change = Clock::now() + kKeyChangeEvery;
    }
    if (options_.steering != nullptr && options_.steering->take_save_request()) observer.save(now);
    if (Clock::now() >= next_progress) {
      observer.progress(now);
      next_progress = Clock::now() + kProgressEvery;
    }
    lock.lock();
  }
}

Progress Frame::progress(const RayQueue& queue, const BlockPool& pool) const {
  Progress progress;
  for (const Stage& stage : stages_) {
    const RootSource::Extent extent = stage.source->extent();
    progress.tiles_done += extent.lit;
    progress.tiles += extent.all;
  }
  progress.traced = traced();
  progress.rays_waiting = queue.waiting();
  progress.queue_bytes = pool.bytes();
  progress.key = key_.load(std::memory_order_relaxed);
  progress.seconds = std::chrono::duration<double>(Clock::now() - begin_ - rested_).count();
  progress.remaining = remaining();
  progress.remaining_is_bound = remaining_is_bound();
  return progress;
}

void Frame::ask_sinks() {
  double sum = 0.0;
  for (const Sink* sink : asked_) sum += sink->outstanding().value_or(0.0);
  remaining_asked_.store(sum, std::memory_order_relaxed);
}

double Frame::remaining() const {
  if (samples_ == 0) return 0.0;
  const double counted = std::ldexp(render::FixedRgb::to_double(remaining_.load(std::memory_order_relaxed)), left_out_);
  return (counted + remaining_asked_.load(std::memory_order_relaxed)) / static_cast<double>(samples_);
}

double Frame::seconds() const {
  const std::lock_guard lock(mutex_);
  return std::chrono::duration<double>(Clock::now() - begin_ - rested_).count();
}

End Frame::end() const {
  const std::lock_guard lock(mutex_);
  return end_;
}

std::string Frame::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

std::optional<std::chrono::steady_clock::time_point> Frame::preview() const {
  const std::lock_guard lock(mutex_);
  return preview_;
}

std::optional<std::chrono::steady_clock::time_point> Frame::first_image() const {
  const std::lock_guard lock(mutex_);
  return first_image_;
}

}  // namespace firstlight::priority
