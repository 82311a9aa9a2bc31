#pragma once

#include "render/scene/object_group.h"

#include <span>
#include <string_view>
#include <vector>

namespace firstlight::priority {

/// Whether a user who says `word` means the surfaces of `group`: it is the identifier of an object that they belong to,
/// however deep within it they are, or the word for their shape.
bool is_called(const render::ObjectGroup& group, std::string_view word);
/// All words that mean some of the objects, each once.
std::vector<std::string_view> object_words(std::span<const render::ObjectGroup> objects);

}  // namespace firstlight::priority
