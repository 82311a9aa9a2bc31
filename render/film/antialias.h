#pragma once

#include "render/film/antialias_settings.h"
#include "render/film/film.h"
#include "render/film/place_sampler.h"
#include "render/film/sample_rounds.h"

#include <memory>
#include <span>

namespace firstlight::render {

/// Decides, once the picture has the colour of one place a pixel, where more are needed and what the pixels become:
/// POV-Ray's anti-aliasing as rounds of samples.
///
/// The place of pixel (x, y) must be (x + base_offset(settings), y + base_offset(settings)).
///
/// Source   POV-Ray 3.7: the same samples, thresholds and means; docs/antialiasing.md.
/// Order    What is asked for depends on the colours alone: not on threads, nor on the order of tracing.
/// Memory   A round that needs more samples than the film has room for is asked for in portions.
class Antialiasing final : public SampleRounds {
 public:
  /// `places`: of the film. Pre: both outlive it.
  Antialiasing(const AntialiasSettings& settings, Film& film, PlaceSampler& places);

  std::span<const SamplePoint> next() override;

 private:
  PlaceSampler& places_;
  std::unique_ptr<SampleRounds> method_;
};

}  // namespace firstlight::render
