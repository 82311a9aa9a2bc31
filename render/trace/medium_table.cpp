#include "render/trace/medium_table.h"

namespace firstlight::render {

MediumTable::MediumTable() { nodes_.push_back({kOutside, kNone, 0}); }

bool MediumTable::contains(std::uint32_t stack, std::uint32_t interior) const {
  for (; stack != kOutside; stack = nodes_[stack].below) {
    if (nodes_[stack].interior == interior) return true;
  }
  return false;
}

std::uint32_t MediumTable::entered(std::uint32_t stack, std::uint32_t interior) {
  const std::uint64_t key = (static_cast<std::uint64_t>(stack) << 32) | interior;
  if (const auto known = numbers_.find(key); known != numbers_.end()) return known->second;
  const auto node = nodes_.push_back({stack, interior, nodes_[stack].depth + 1});
  // Two threads may get here with the same key: both nodes describe the same stack, the first to insert is used.
  return numbers_.insert({key, static_cast<std::uint32_t>(node - nodes_.begin())}).first->second;
}

std::uint32_t MediumTable::left(std::uint32_t stack, std::uint32_t interior) {
  const Node node = nodes_[stack];
  if (node.interior == interior) return node.below;
  return entered(left(node.below, interior), node.interior);
}

}  // namespace firstlight::render
