#include "priority/object_names.h"
#include "priority/object_scheme.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace firstlight::priority {
namespace {

constexpr Key kMostWords = 1000;

// Without a list: in the order in which the scene describes its objects.
SchemePtr in_scene_order(std::span<const render::ObjectGroup> objects) {
  const Key groups = std::max<Key>(static_cast<Key>(objects.size()), 1);
  const Key count = std::min(groups, kMostWords);
  std::vector<Key> keys(objects.size());
  for (Key group = 0; group < keys.size(); ++group) keys[group] = (groups - 1 - group) * count / groups;
  return std::make_shared<ObjectScheme>(std::move(keys), count);
}

std::vector<Piece> read_words(std::span<const render::ObjectGroup> objects, SchemeText& text) {
  const std::vector<std::string_view> known = object_words(objects);
  std::vector<Piece> words;
  do {
    const Piece word = text.identifier("the name of an object");
    if (!std::ranges::binary_search(known, word.text)) {
      text.fail(word, fmt::format("the scene has no object '{}'{}", word.text, nearest_hint(word.text, known)));
    }
    if (std::ranges::find(words, word.text, &Piece::text) != words.end()) {
      text.fail(word, fmt::format("'{}' is named twice", word.text));
    }
    if (words.size() == kMostWords) text.fail(word, fmt::format("more than {} objects", kMostWords));
    words.push_back(word);
    text.accept(',');
  } while (!text.next_is(')') && !text.at_end());
  return words;
}

}  // namespace

/// By the object that a ray left, in the order that the user names them; rays of all others leave last.
/// Source   Yagel & Meeker 1997, section 4, "object".
SchemePtr make_object(const SchemeInput& input, SchemeText* arguments) {
  const std::span<const render::ObjectGroup> objects = input.scene.objects;
  if (arguments == nullptr) return in_scene_order(objects);
  const std::vector<Piece> words = read_words(objects, *arguments);
  const auto count = static_cast<Key>(words.size()) + 1;
  std::vector<Key> keys(objects.size(), 0);
  for (std::size_t group = 0; group < keys.size(); ++group) {
    const auto first =
        std::ranges::find_if(words, [&](const Piece& word) { return is_called(objects[group], word.text); });
    if (first != words.end()) keys[group] = count - 1 - static_cast<Key>(first - words.begin());
  }
  return std::make_shared<ObjectScheme>(std::move(keys), count);
}

}  // namespace firstlight::priority
