#pragma once

#include <cstdint>
#include <vector>

namespace firstlight::parser {

/// The streams of `seed` and `rand`. Their sequence is POV-Ray's own, for scenes place things by it:
/// state' = state * 1812433253 + 12345 modulo 2^32, value = state' / (2^32 - 1). [POV-Ray 3.7]
class RandomStreams {
 public:
  /// The number of the new stream.
  std::size_t open(std::int32_t seed) {
    states_.push_back(static_cast<std::uint32_t>(seed));
    return states_.size() - 1;
  }
  std::size_t count() const { return states_.size(); }
  /// In [0, 1]. Pre: stream < count().
  double next(std::size_t stream) {
    states_[stream] = states_[stream] * 1812433253u + 12345u;
    return states_[stream] / 4294967295.0;
  }

 private:
  std::vector<std::uint32_t> states_;
};

}  // namespace firstlight::parser
