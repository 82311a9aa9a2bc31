#include "app/study/watch.h"

#include "render/film/preview.h"

#include <array>
#include <utility>

namespace firstlight::app {
namespace {

/// Shares of the rays at which a picture is kept.
constexpr std::array kPictureShares{0.02, 0.05, 0.10, 0.20, 0.35, 0.60};

}  // namespace

FinishedPicture::FinishedPicture(std::vector<render::Rgb> colors, int width, int height,
                                 const render::Encoding& encoding)
    : colors_(std::move(colors)),
      encoding_(encoding),
      light_(light(colors_)),
      difference_(light_),
      flip_(light_, width, height) {}

void FinishedPicture::compare(std::span<const render::Rgb> colors, Moment& moment) const {
  const std::vector<render::Rgb> shown = light(colors);
  moment.difference = difference_(shown);
  moment.flip = flip_.mean(shown);
}

double FinishedPicture::flip_of_black() const {
  return flip_.mean(std::vector<render::Rgb>(light_.size(), render::Rgb(0.0f)));
}

std::vector<render::Rgb> FinishedPicture::light(std::span<const render::Rgb> colors) const {
  std::vector<render::Rgb> result;
  result.reserve(colors.size());
  for (const render::Rgb& color : colors) {
    result.emplace_back(encoding_.light(color.x), encoding_.light(color.y), encoding_.light(color.z));
  }
  return result;
}

Watcher::Watcher(const render::Film& film, const FinishedPicture& finished, std::uint64_t rays, KeepPicture keep)
    : film_(film), finished_(finished), rays_(static_cast<double>(rays)), keep_(std::move(keep)) {}

void Watcher::checkpoint(const priority::Progress& progress) {
  const std::vector<render::Rgb> picture = render::preview(film_);
  Moment moment;
  moment.seconds = progress.seconds;
  moment.traced = progress.traced;
  moment.rays_waiting = progress.rays_waiting;
  moment.queue_bytes = progress.queue_bytes;
  moment.bound = progress.remaining;
  finished_.compare(picture, moment);
  if (!progress.remaining_is_bound) bound_is_proved_ = false;

  const double share = static_cast<double>(progress.traced.traced()) / rays_;
  if (keep_ && pictures_.size() < kPictureShares.size() && share >= kPictureShares[pictures_.size()]) {
    pictures_.push_back({share, moment.seconds, moment.difference, keep_(share, picture)});
  }
  moments_.push_back(moment);
}

}  // namespace firstlight::app
