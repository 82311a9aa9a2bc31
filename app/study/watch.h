#pragma once

#include "app/study/study.h"
#include "priority/observer.h"
#include "render/film/film.h"
#include "render/image/difference.h"
#include "render/image/encode.h"
#include "render/image/flip.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace firstlight::app {

/// The finished picture, and how far others are from it.
class FinishedPicture {
 public:
  /// `colors` in the scene's working numbers.
  FinishedPicture(std::vector<render::Rgb> colors, int width, int height, const render::Encoding& encoding);

  const std::vector<render::Rgb>& colors() const { return colors_; }
  /// Sets moment.difference and moment.flip.
  void compare(std::span<const render::Rgb> colors, Moment& moment) const;
  double flip_of_black() const;

 private:
  std::vector<render::Rgb> light(std::span<const render::Rgb> colors) const;

  std::vector<render::Rgb> colors_;
  render::Encoding encoding_;
  std::vector<render::Rgb> light_;
  render::RemainingDifference difference_;
  render::Flip flip_;
};

/// Looks at a picture whenever the workers rest.
class Watcher final : public priority::Observer {
 public:
  /// Returns the bytes of a small PNG.
  using KeepPicture = std::function<std::string(double share, std::span<const render::Rgb> colors)>;

  /// `rays`: as many as are traced for the whole picture.
  Watcher(const render::Film& film, const FinishedPicture& finished, std::uint64_t rays, KeepPicture keep);

  void checkpoint(const priority::Progress& progress) override;

  std::vector<Moment> take_moments() { return std::move(moments_); }
  std::vector<MomentPicture> take_pictures() { return std::move(pictures_); }
  bool bound_is_proved() const { return bound_is_proved_; }

 private:
  const render::Film& film_;
  const FinishedPicture& finished_;
  const double rays_;
  const KeepPicture keep_;
  std::vector<Moment> moments_;
  std::vector<MomentPicture> pictures_;
  bool bound_is_proved_ = true;
};

}  // namespace firstlight::app
