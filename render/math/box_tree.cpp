#include "render/math/box_tree.h"

#include <algorithm>

namespace firstlight::render {

BoxTree::BoxTree(std::span<const Box3> boxes) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].isEmpty()) continue;
    (is_bounded(boxes[i]) ? order : boundless_).push_back(i);
  }
  if (!order.empty()) build(boxes, order);
}

void BoxTree::build(std::span<const Box3> boxes, std::span<std::uint32_t> order) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Box3 box;
  for (const std::uint32_t index : order) box.extendBy(boxes[index]);
  nodes_[at].box = box;
  if (order.size() == 1) {
    nodes_[at].index = order[0];
  } else {
    const auto axis = static_cast<int>(box.majorAxis());
    const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
    std::nth_element(order.begin(), middle, order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double ca = boxes[a].min[axis] + boxes[a].max[axis];
      const double cb = boxes[b].min[axis] + boxes[b].max[axis];
      return ca < cb || (ca == cb && a < b);
    });
    build(boxes, order.first(order.size() / 2));
    build(boxes, order.subspan(order.size() / 2));
  }
  nodes_[at].after = static_cast<std::uint32_t>(nodes_.size());
}

void BoxTree::met_by(const Ray& ray, std::vector<std::uint32_t>& out) const {
  out.insert(out.end(), boundless_.begin(), boundless_.end());
  std::uint32_t at = 0;
  while (at < nodes_.size()) {
    const Node& node = nodes_[at];
    if (!meets(ray, node.box)) {
      at = node.after;
      continue;
    }
    if (node.index != kInner) out.push_back(node.index);
    ++at;
  }
}

}  // namespace firstlight::render
