#include "priority/driver.h"

#include "priority/block_pool.h"
#include "priority/depth_first.h"
#include "priority/frame.h"
#include "priority/picture.h"
#include "priority/ray_queue.h"
#include "priority/steering.h"
#include "priority/worker.h"
#include "render/math/interrupt.h"
#include "render/scene/scene_index.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

std::string reason_of(const std::exception& exception) {
  return dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ? "not enough memory" : exception.what();
}

// The whole life of a worker thread. No exception leaves it.
void work(Frame& frame, Shared& shared, const TraceOptions& options, std::size_t number, render::RayCounts& counts) {
  const render::Interrupt interrupt(frame.wish_to_end());
  try {
    render::Tracer tracer(frame.context(), frame.surfaces());
    if (options.scheme == nullptr) {
      trace_recursively(frame, tracer, shared.queue, number);
    } else {
      const auto worker = std::make_unique<Worker>(frame, tracer, shared, options, number);
      worker->run();
    }
    counts = tracer.counts();
  } catch (const std::exception& exception) {
    frame.fail(reason_of(exception));
  }
  if (frame.stopped()) shared.queue.close();
  frame.leave();
}

/// The most feelers of a hit: area lights may take one for each of their points.
std::uint64_t most_feelers(std::span<const render::Light> lights) {
  std::uint64_t sum = 0;
  for (const render::Light& light : lights) {
    sum +=
        light.area ? static_cast<std::uint64_t>(light.area->size1) * static_cast<std::uint64_t>(light.area->size2) : 1;
  }
  return sum;
}

TraceStatistics statistics_of(const Frame& frame, const Shared& shared, const std::vector<render::RayCounts>& counts) {
  TraceStatistics statistics;
  for (const render::RayCounts& own : counts) statistics.rays += own;
  statistics.peak_rays = shared.queue.peak_rays();
  statistics.peak_bytes = shared.pool.peak_bytes();
  if (statistics.peak_rays > 0) {
    statistics.bytes_per_ray = static_cast<double>(statistics.peak_bytes) / static_cast<double>(statistics.peak_rays);
  }
  statistics.inverted_rays = shared.inverted_rays;
  statistics.rekeying = shared.queue.rekeying();
  statistics.seconds = frame.seconds();
  statistics.remaining = frame.end() == End::complete ? 0.0 : frame.remaining();
  statistics.remaining_is_bound = frame.remaining_is_bound();
  statistics.preview = frame.preview();
  statistics.first_image = frame.first_image();
  return statistics;
}

}  // namespace

TraceResult trace(const render::TraceContext& context, std::span<const Pass> passes, const TraceOptions& options) {
  TraceResult result;
  try {
    TraceOptions own = options;
    std::shared_ptr<const Scheme> first;
    if (options.steering != nullptr) {
      first = options.steering->scheme();
      own.scheme = first.get();
    }
    Frame frame(context, passes, own);
    const auto shared = std::make_unique<Shared>(own, frame.samples());
    std::vector<render::RayCounts> counts(static_cast<std::size_t>(own.threads));
    {
      std::vector<std::jthread> threads;
      threads.reserve(counts.size());
      try {
        for (std::size_t i = 0; i < counts.size(); ++i) {
          threads.emplace_back([&, i] { work(frame, *shared, own, i, counts[i]); });
        }
        frame.watch(shared->queue, shared->pool);
      } catch (const std::exception& exception) {
        frame.fail(reason_of(exception));
        shared->queue.close();
      }
    }
    result.statistics = statistics_of(frame, *shared, counts);
    result.end = frame.end();
    result.error = frame.error();
    const render::SceneIndex scene = render::index_of(context.scene);
    result.statistics.worst_case_rays =
        worst_case_rays(frame.samples(), most_feelers(scene.lights), scene.max_trace_level);
  } catch (const std::exception& exception) {
    result.error = reason_of(exception);
  }
  return result;
}

TraceResult trace(const render::TraceContext& context, render::Film& film, const TraceOptions& options) {
  TraceResult result;
  try {
    const bool has_queue = (options.steering != nullptr ? options.steering->scheme().get() : options.scheme) != nullptr;
    film.deal_out(options.threads);
    render::TraceContext asking = context;
    asking.with_alpha = film.has_alpha();
    const Picture picture(
        asking, film,
        has_queue ? render::PrimaryTiles::Order::coarse_to_fine : render::PrimaryTiles::Order::square_by_square,
        options.antialias);
    return trace(asking, picture.passes(), options);
  } catch (const std::exception& exception) {
    result.error = reason_of(exception);
  }
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
