#pragma once

#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Numbers by place: a hash table with open addressing that keeps its memory between uses.
class PlaceTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  /// Empties the table, and makes room for `most` places.
  void begin(std::size_t most);
  /// The number at a place, kNone where there is none yet; may be set through the reference. Pre: no more places than
  /// there is room for.
  std::uint32_t& at(std::uint32_t x, std::uint32_t y);

 private:
  struct Entry {
    std::uint32_t x;
    std::uint32_t y;
    std::uint32_t number = kNone;
  };
  std::vector<Entry> entries_;
  std::size_t mask_ = 0;
};

}  // namespace firstlight::render
