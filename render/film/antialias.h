#pragma once

#include "render/film/antialias_settings.h"
#include "render/film/film.h"
#include "render/film/sample_rounds.h"

#include <memory>
#include <span>

namespace firstlight::render {

/// Decides, once the picture has one sample a pixel, where more are needed and what the pixels become: POV-Ray's
/// anti-aliasing as rounds of samples.
///
/// The first sample of pixel (x, y) must be the light through (x + base_offset(settings), y + base_offset(settings)).
///
/// Source   POV-Ray 3.7: the same samples, thresholds and means; docs/antialiasing.md.
/// Order    What is asked for depends on the colours alone: not on threads, nor on the order of tracing.
/// Memory   The film gets room for as many samples as it has pixels, at least 2^18 and at most 2^22; a round that needs
///          more is asked for in portions. Throws std::bad_alloc when there is not even room for a small one.
class Antialiasing final : public SampleRounds {
 public:
  /// To be made before anything is added to `film`.
  Antialiasing(const AntialiasSettings& settings, Film& film);

  std::span<const SamplePoint> next() override { return method_->next(); }

 private:
  std::unique_ptr<SampleRounds> method_;
};

}  // namespace firstlight::render
