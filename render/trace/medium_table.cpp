#include "render/trace/medium_table.h"

namespace firstlight::render {

MediumTable::MediumTable() { nodes_.push_back({kOutside, kNone, 0, {}}); }

bool MediumTable::contains(std::uint32_t stack, std::uint32_t interior) const {
  for (; !is_outside(stack); stack = nodes_[stack].below) {
    if (nodes_[stack].interior == interior) return true;
  }
  return false;
}

std::uint32_t MediumTable::numbered(std::uint64_t key, const Node& node) {
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const auto made = nodes_.push_back(node);
  // Two threads may get here with the same key: both nodes describe the same stack, the first to insert is used.
  return numbers_.insert({key, static_cast<std::uint32_t>(made - nodes_.begin())}).first->second;
}

std::uint32_t MediumTable::entered(std::uint32_t stack, std::uint32_t interior) {
  const Node& below = nodes_[stack];
  return numbered((static_cast<std::uint64_t>(stack) << 32) | interior, {stack, interior, below.depth + 1, below.band});
}

std::uint32_t MediumTable::left(std::uint32_t stack, std::uint32_t interior) {
  const Node node = nodes_[stack];
  if (node.interior == interior) return node.below;
  return entered(left(node.below, interior), node.interior);
}

std::uint32_t MediumTable::in_band(std::uint32_t stack, SpectralBand band) {
  if (!is_outside(stack)) return entered(in_band(nodes_[stack].below, band), innermost(stack));
  // No stack is entered from kNone.
  const std::uint64_t key = (static_cast<std::uint64_t>(kNone) << 32) | std::uint32_t{band.count} << 16 | band.number;
  return numbered(key, {kOutside, kNone, 0, band});
}

}  // namespace firstlight::render
