#pragma once

#include "render/scene/object_group.h"

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace firstlight::render {

/// Numbers the groups of a scene's surfaces while it is built, in the order in which they are met.
class ObjectTable {
 public:
  /// A way of identifiers from the outermost object inwards, as a number; 0: no identifiers.
  using Names = std::uint32_t;

  /// The way that goes on from `outer` through `names`.
  Names within(Names outer, std::span<const std::string> names);
  std::vector<std::string> names_of(Names way) const;

  /// The number of a group, less than kMostObjectGroups. `shape` is static text.
  std::uint32_t group(Names names, std::string_view shape, SurfaceKind surface, std::uint64_t size);
  std::vector<ObjectGroup> take() { return std::move(groups_); }

 private:
  static constexpr std::uint32_t kLongestWay = 64;  // what is nested deeper goes by the outermost of its names

  struct Step {
    Names outer = 0;
    std::uint32_t length = 0;  // names on the way
    std::string name;
  };
  struct Key {
    Names names;
    std::uint32_t shape;
    SurfaceKind surface;
    std::uint8_t complexity;

    auto operator<=>(const Key&) const = default;
  };

  std::uint32_t shape_number(std::string_view shape);

  std::vector<Step> steps_{1};  // by Names; the first stands for no identifiers
  std::map<std::pair<Names, std::string>, Names> ways_;
  std::map<std::string, std::uint32_t, std::less<>> shapes_;
  std::map<Key, std::uint32_t> numbers_;
  // The last answers are kept, for the next question is mostly the same.
  std::string_view last_shape_;
  std::uint32_t last_shape_number_ = 0;
  std::optional<std::pair<Key, std::uint32_t>> last_;
  std::vector<ObjectGroup> groups_;
};

}  // namespace firstlight::render
