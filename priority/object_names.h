#pragma once

#include "render/scene/scene.h"

#include <string_view>
#include <vector>

namespace firstlight::priority {

/// Whether a user who says `word` means the surfaces of `group`: it is the identifier of an object that they belong to,
/// however deep within it they are, or the word for their shape.
bool is_called(const render::ObjectGroup& group, std::string_view word);
/// All words that mean some object of the scene, each once.
std::vector<std::string_view> object_words(const render::Scene& scene);

}  // namespace firstlight::priority
