#pragma once

#include "render/scene/object.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace firstlight::render {

/// Goes through the members of `whole` in order, without recursion: unions nest as deep as a loop makes them.
/// `enter(member, state)` gives the state that holds inside of a member that is to be replaced by its own members, or
/// nothing for one that is to be visited. `visit(member, state)` gets the state of what the member is in.
template <class State, class Enter, class Visit>
void walk_members(const Object& whole, State state, const Enter& enter, const Visit& visit) {
  struct Level {
    const std::vector<Object>* members;
    std::size_t next;
    State state;
  };
  std::vector<Level> levels;
  const auto descend = [&levels](const Object& object, State inside) {
    if (object.children) levels.push_back({object.children.get(), 0, std::move(inside)});
  };
  descend(whole, std::move(state));
  while (!levels.empty()) {
    Level& level = levels.back();
    if (level.next == level.members->size()) {
      levels.pop_back();
      continue;
    }
    const Object& member = (*level.members)[level.next++];
    std::optional<State> inside = enter(member, level.state);
    if (inside) {
      descend(member, *std::move(inside));
    } else {
      visit(member, level.state);
    }
  }
}

}  // namespace firstlight::render
