#include "render/scene/object_table.h"

#include <algorithm>
#include <bit>

namespace firstlight::render {

ObjectTable::Names ObjectTable::within(Names outer, std::span<const std::string> names) {
  for (const std::string& name : names) {
    // A loop that declares an object of itself gives its name again and again.
    if (steps_[outer].name == name && outer != 0) continue;
    if (steps_[outer].length == kLongestWay) break;
    const auto [way, is_new] = ways_.try_emplace({outer, name}, static_cast<Names>(steps_.size()));
    if (is_new) steps_.push_back({outer, steps_[outer].length + 1, name});
    outer = way->second;
  }
  return outer;
}

std::vector<std::string> ObjectTable::names_of(Names way) const {
  std::vector<std::string> names;
  for (; way != 0; way = steps_[way].outer) names.push_back(steps_[way].name);
  std::ranges::reverse(names);
  return names;
}

std::uint32_t ObjectTable::shape_number(std::string_view shape) {
  if (!shapes_.empty() && shape.data() == last_shape_.data() && shape.size() == last_shape_.size()) {
    return last_shape_number_;
  }
  auto word = shapes_.find(shape);
  if (word == shapes_.end()) word = shapes_.emplace(shape, static_cast<std::uint32_t>(shapes_.size())).first;
  last_shape_ = shape;
  return last_shape_number_ = word->second;
}

std::uint32_t ObjectTable::group(Names names, std::string_view shape, SurfaceKind surface, std::uint64_t size) {
  const Key key{names, shape_number(shape), surface, static_cast<std::uint8_t>(std::bit_width(size))};
  if (last_ && last_->first == key) return last_->second;
  if (const auto found = numbers_.find(key); found != numbers_.end()) {
    last_ = *found;
    return found->second;
  }
  const auto number = static_cast<std::uint32_t>(groups_.size());
  if (number == kMostObjectGroups) return number - 1;
  if (number + 1 == kMostObjectGroups) {
    groups_.emplace_back();
    return number;
  }
  groups_.push_back({names_of(names), std::string(shape), surface, key.complexity});
  numbers_.emplace(key, number);
  return number;
}

}  // namespace firstlight::render
