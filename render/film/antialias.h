#pragma once

#include "render/film/antialias_settings.h"
#include "render/film/film.h"

#include <cstdint>
#include <memory>
#include <span>

namespace firstlight::render {

/// A sample beyond the first of its pixel.
struct SamplePoint {
  double x = 0.0;  ///< picture coordinates, as PicturePlaces::add() takes them; may lie a pixel outside of the picture
  double y = 0.0;
  std::uint32_t sample = 0;  ///< on the film
};

/// Decides, once the picture has one sample a pixel, where more are needed and what the pixels become: POV-Ray's
/// anti-aliasing as rounds of samples.
///
/// The first sample of pixel (x, y) must be the light through (x + base_offset(settings), y + base_offset(settings)).
///
/// Source   POV-Ray 3.7: the same samples, thresholds and means; docs/antialiasing.md.
/// Order    What is asked for depends on the colours alone: not on threads, nor on the order of tracing.
/// Memory   The film gets room for as many samples as it has pixels, at least 2^18 and at most 2^22; a round that needs
///          more is asked for in portions. Throws std::bad_alloc when there is not even room for a small one.
/// Threads  One thread calls; others may read the film.
class Antialiasing {
 public:
  /// To be made before anything is added to `film`.
  Antialiasing(const AntialiasSettings& settings, Film& film);
  ~Antialiasing();

  /// What to trace next; empty: the picture is finished. To be called when all samples asked for so far are complete,
  /// no ray waits and nobody adds. The film's samples beyond its pixels begin anew.
  std::span<const SamplePoint> next();

  /// One of the methods.
  class Method {
   public:
    virtual ~Method() = default;
    virtual std::span<const SamplePoint> next() = 0;
  };

 private:
  std::unique_ptr<Method> method_;
};

}  // namespace firstlight::render
