#include "priority/object_names.h"

#include <algorithm>

namespace firstlight::priority {

bool is_called(const render::ObjectGroup& group, std::string_view word) {
  return group.shape == word || std::ranges::find(group.names, word) != group.names.end();
}

std::vector<std::string_view> object_words(std::span<const render::ObjectGroup> objects) {
  std::vector<std::string_view> words;
  for (const render::ObjectGroup& group : objects) {
    words.insert(words.end(), group.names.begin(), group.names.end());
    if (!group.shape.empty()) words.push_back(group.shape);
  }
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

}  // namespace firstlight::priority
