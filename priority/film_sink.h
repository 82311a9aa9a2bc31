#pragma once

#include "priority/sink.h"
#include "render/film/film.h"

namespace firstlight::priority {

/// The film as a sink; anti-aliasing shares its samples beyond the pixels.
class FilmSink final : public Sink {
 public:
  /// Pre: the film outlives it.
  explicit FilmSink(render::Film& film) : film_(film) {}

  std::uint64_t samples() const override { return film_.pixels(); }
  void expect(std::int64_t most) override { film_.expect(most); }
  void add(std::span<const render::Contribution> light) override { film_.add(light); }
  void add_clearness(std::span<const render::Clearness> clearness) override { film_.add(clearness); }
  void fetch(std::span<const render::RayTask> tasks) const override {
    for (const render::RayTask& task : tasks) film_.fetch(task.sample);
  }
  // Pixels that may get more samples are not what their waiting rays make of them, so each of them has to be asked.
  std::optional<double> outstanding() const override {
    if (film_.room() == 0) return std::nullopt;
    double sum = 0.0;
    for (int y = 0; y < film_.height(); ++y) {
      for (int x = 0; x < film_.width(); ++x) sum += film_.outstanding(x, y);
    }
    return sum;
  }

 private:
  render::Film& film_;
};

}  // namespace firstlight::priority
