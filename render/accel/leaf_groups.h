#pragma once

#include "render/accel/wide_tree.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace firstlight::render {

/// The leaves that rays of a block have come to, and which rays: those of a leaf meet it together.
///
/// Memory   eight bytes a leaf and kind, and what waits.
/// Threads  one has one.
class LeafGroups {
 public:
  /// That of the calling thread, in which nothing waits.
  static LeafGroups& of_thread() {
    thread_local LeafGroups groups;
    return groups;
  }

  /// Pre: nothing waits.
  void make_room(std::size_t leaves_of_a_kind) {
    if (rays_.size() < 2 * leaves_of_a_kind) rays_.resize(2 * leaves_of_a_kind);
  }
  void add(ChildRef leaf, std::size_t ray) {
    std::uint64_t& rays = rays_[slot(leaf)];
    if (rays == 0) leaves_.push_back(leaf);
    rays |= std::uint64_t{1} << ray;
  }
  /// Those that are waited at.
  std::span<const ChildRef> leaves() const { return leaves_; }
  /// Bits of the rays at a leaf, which wait no longer.
  std::uint64_t take(ChildRef leaf) { return std::exchange(rays_[slot(leaf)], 0); }
  /// By the depth at which the first ray of each comes to it: `depth(leaf, ray)`.
  template <class Depth>
  void sort(const Depth& depth) {
    if (leaves_.size() < 2) return;
    order_.clear();
    for (const ChildRef leaf : leaves_) {
      order_.push_back({depth(leaf, static_cast<std::size_t>(__builtin_ctzll(rays_[slot(leaf)]))), leaf});
    }
    std::sort(order_.begin(), order_.end(), [](const Entry& a, const Entry& b) { return a.depth < b.depth; });
    for (std::size_t i = 0; i < order_.size(); ++i) leaves_[i] = order_[i].leaf;
  }
  /// Nothing waits.
  void clear() {
    for (const ChildRef leaf : leaves_) rays_[slot(leaf)] = 0;
    leaves_.clear();
  }

 private:
  struct Entry {
    double depth;
    ChildRef leaf;
  };

  /// The kinds of leaf but spheres are two.
  static std::size_t slot(ChildRef leaf) {
    static_assert((static_cast<unsigned>(ChildKind::box) ^ static_cast<unsigned>(ChildKind::solid)) == 1);
    return 2 * std::size_t{leaf.index()} + (static_cast<unsigned>(leaf.kind()) & 1);
  }

  std::vector<std::uint64_t> rays_;  // 0 where none waits
  std::vector<ChildRef> leaves_;
  std::vector<Entry> order_;
};

}  // namespace firstlight::render
