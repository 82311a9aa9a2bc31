#pragma once

#include "priority/root_source.h"
#include "render/film/sample_rounds.h"

#include <atomic>
#include <mutex>
#include <span>

namespace firstlight::priority {

/// Samples beyond the first of each pixel, round by round, as what is on the film asks for them. They come before all
/// rays that wait.
class RoundSource final : public RootSource {
 public:
  /// Pre: both outlive it.
  RoundSource(const render::PrimaryRays& rays, render::SampleRounds& rounds) : rays_(rays), rounds_(rounds) {}

  int top() const override { return top_.load(std::memory_order_relaxed); }
  bool next(std::size_t worker, Roots& roots) override;
  bool refill() override;

 private:
  std::span<const render::SamplePoint> take();

  const render::PrimaryRays& rays_;
  render::SampleRounds& rounds_;
  std::mutex mutex_;
  std::span<const render::SamplePoint> points_;  // that have not begun
  std::atomic<int> top_ = kNoSlot;
};

}  // namespace firstlight::priority
