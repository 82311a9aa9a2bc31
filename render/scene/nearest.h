#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// The member of `known` that is fewest edits away from `word`, empty when none is near: for "did you mean".
/// Letters that differ in case only count as the same, unless another member is the word's equal.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

}  // namespace firstlight::render
