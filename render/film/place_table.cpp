#include "render/film/place_table.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace firstlight::render {

void PlaceTable::begin(std::size_t most) {
  const std::size_t size = std::bit_ceil(2 * most + 1);
  entries_.assign(size, Entry());
  mask_ = size - 1;
}

std::uint32_t& PlaceTable::at(std::uint32_t x, std::uint32_t y) {
  const std::uint64_t key = std::uint64_t{x} << 32 | y;
  std::size_t i = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 20) & mask_;
  while (entries_[i].number != kNone && (entries_[i].x != x || entries_[i].y != y)) i = (i + 1) & mask_;
  entries_[i].x = x;
  entries_[i].y = y;
  return entries_[i].number;
}

}  // namespace firstlight::render
