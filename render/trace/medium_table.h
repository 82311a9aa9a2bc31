#pragma once

#include "render/light/spectrum.h"

#include <tbb/concurrent_unordered_map.h>
#include <tbb/concurrent_vector.h>

#include <cstdint>

namespace firstlight::render {

/// The interiors a ray is inside of, oldest first, and the part of the spectrum that it has been split to, as a number that
/// fits into a ray task. Equal ways through matter give equal stacks; numbers differ from run to run, and nothing visible
/// depends on them.
///
/// Memory   one node a distinct stack, kept for the whole frame.
/// Threads  all members may be called from any thread.
/// Source   Which interior is left or entered, and what surrounds it then, is POV-Ray 3.7's rule.
class MediumTable {
 public:
  static constexpr std::uint32_t kOutside = 0;  ///< of everything, for white light
  static constexpr std::uint32_t kNone = 0xffffffffu;

  MediumTable();

  bool is_outside(std::uint32_t stack) const { return stack == kOutside || nodes_[stack].depth == 0; }
  bool contains(std::uint32_t stack, std::uint32_t interior) const;
  /// The interior entered last, kNone outside of everything.
  std::uint32_t innermost(std::uint32_t stack) const { return nodes_[stack].interior; }
  /// Number of interiors on the stack.
  std::uint32_t depth(std::uint32_t stack) const { return nodes_[stack].depth; }
  std::uint32_t entered(std::uint32_t stack, std::uint32_t interior);
  /// Pre: contains(stack, interior).
  std::uint32_t left(std::uint32_t stack, std::uint32_t interior);
  SpectralBand band(std::uint32_t stack) const { return nodes_[stack].band; }
  /// The same interiors, for light of the band. Pre: it is not white.
  std::uint32_t in_band(std::uint32_t stack, SpectralBand band);

 private:
  struct Node {
    std::uint32_t below;
    std::uint32_t interior;
    std::uint32_t depth;
    SpectralBand band;
  };
  /// The node of that key, which is made from `node` where there is none.
  std::uint32_t numbered(std::uint64_t key, const Node& node);

  tbb::concurrent_vector<Node> nodes_;
  tbb::concurrent_unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace firstlight::render
