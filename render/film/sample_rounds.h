#pragma once

#include <cstdint>
#include <span>

namespace firstlight::render {

/// A sample beyond the first of its pixel.
struct SamplePoint {
  double x = 0.0;  ///< picture coordinates, as PicturePlaces::add() takes them; may lie a pixel outside of the picture
  double y = 0.0;
  std::uint32_t sample = 0;  ///< on the film
  std::uint32_t number = 0;  ///< among the samples of its place, of which focal blur takes several
};

/// Rounds of samples that refine a picture: what is asked for depends on the colours that are there.
///
/// Threads  One thread calls; others may read the film.
class SampleRounds {
 public:
  virtual ~SampleRounds() = default;
  /// Returns what to trace next; empty: nothing is left to do. To be called when all samples asked for so far are
  /// complete, no ray waits and nobody adds. The film's samples beyond its pixels begin anew.
  virtual std::span<const SamplePoint> next() = 0;
};

}  // namespace firstlight::render
