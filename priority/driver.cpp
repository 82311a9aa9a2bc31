#include "priority/driver.h"

#include "priority/block_pool.h"
#include "priority/depth_first.h"
#include "priority/frame.h"
#include "priority/ray_queue.h"
#include "priority/worker.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

/// What the workers of a queued scheme share.
struct Shared {
  explicit Shared(int threads) : queue(pool, threads) {}

  BlockPool pool;
  RayQueue queue;
};

std::string reason_of(const std::exception& exception) {
  return dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ? "not enough memory" : exception.what();
}

// The whole life of a worker thread. No exception leaves it.
void work(Frame& frame, Shared* shared, const TraceOptions& options, render::RayCounts& counts) {
  try {
    render::Stepper stepper(frame.context());
    if (shared == nullptr) {
      trace_recursively(frame, stepper);
    } else {
      const auto worker =
          std::make_unique<Worker>(frame, stepper, shared->pool, shared->queue, *options.scheme, options.queue_budget);
      worker->run();
    }
    counts = stepper.counts();
  } catch (const std::exception& exception) {
    frame.fail(reason_of(exception));
  }
  if (shared != nullptr && frame.stopped()) shared->queue.close();
  frame.leave();
}

}  // namespace

TraceResult trace(const render::TraceContext& context, render::Film& film, const TraceOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  TraceResult result;
  try {
    Frame frame(context, film, options);
    const auto shared = options.scheme != nullptr ? std::make_unique<Shared>(options.threads) : nullptr;
    std::vector<render::RayCounts> counts(static_cast<std::size_t>(options.threads));
    {
      std::vector<std::jthread> threads;
      threads.reserve(counts.size());
      try {
        for (render::RayCounts& own : counts) {
          threads.emplace_back([&frame, &shared, &options, &own] { work(frame, shared.get(), options, own); });
        }
        frame.watch(options.observer, shared != nullptr ? &shared->queue : nullptr);
      } catch (const std::exception& exception) {
        frame.fail(reason_of(exception));
        if (shared != nullptr) shared->queue.close();
      }
    }
    TraceStatistics& statistics = result.statistics;
    for (const render::RayCounts& own : counts) statistics.rays += own;
    if (shared != nullptr) {
      statistics.peak_rays = shared->queue.peak_rays();
      statistics.peak_bytes = shared->pool.peak_bytes();
      if (statistics.peak_rays > 0) {
        statistics.bytes_per_ray =
            static_cast<double>(statistics.peak_bytes) / static_cast<double>(statistics.peak_rays);
      }
    }
    statistics.first_image = frame.first_image();
    result.error = frame.error();
    result.complete = !frame.stopped();
  } catch (const std::exception& exception) {
    result.error = reason_of(exception);
  }
  const std::uint64_t samples = static_cast<std::uint64_t>(film.width()) * static_cast<std::uint64_t>(film.height());
  result.statistics.worst_case_rays =
      worst_case_rays(samples, context.scene.lights.size(), context.scene.settings.max_trace_level);
  result.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::uint64_t worst_case_rays(std::uint64_t samples, std::uint64_t lights, int max_trace_level) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const auto product = [](std::uint64_t a, std::uint64_t b) {
    std::uint64_t out = 0;
    return __builtin_mul_overflow(a, b, &out) ? kMost : out;
  };
  const std::uint64_t nodes = max_trace_level + 1 >= 64 ? kMost : (std::uint64_t{1} << (max_trace_level + 1)) - 1;
  return product(samples, product(std::max<std::uint64_t>(lights, 1), nodes));
}

}  // namespace firstlight::priority
