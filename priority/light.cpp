// Criteria that order shadow feelers by their light.
// Source   Yagel & Meeker 1997, section 4, further criteria: light intensity, and "future work": colour and distance.
#include "priority/feeler_scheme.h"
#include "priority/log_scale.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

namespace firstlight::priority {
namespace {

using render::PackedRgb;
using render::RayTask;

template <class KeyOf>
SchemePtr feeler_scheme(Key count, KeyOf key_of) {
  return std::make_shared<FeelerScheme<KeyOf>>(count, std::move(key_of));
}

/// A scheme with a key for each light.
SchemePtr by_light(std::vector<Key> keys, Key count) {
  return feeler_scheme(count, [keys = std::move(keys)](const RayTask&, std::uint32_t light, const PackedRgb&) {
    return light < keys.size() ? keys[light] : 0;
  });
}

/// Marks the lights that a user means by their identifier or their number, counted from 0.
void give_key(const render::SceneIndex& scene, SchemeText& text, Key key, std::vector<Key>& keys) {
  const Piece word = text.next();
  std::vector<std::size_t> lights;
  if (text.at_number()) {
    const int number = text.integer("the number of a light");
    if (number >= 0 && static_cast<std::size_t>(number) < keys.size())
      lights.push_back(static_cast<std::size_t>(number));
  } else {
    text.identifier("a light's name or number");
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (std::ranges::find(scene.light_names[i], word.text) != scene.light_names[i].end()) lights.push_back(i);
    }
  }
  if (lights.empty()) {
    std::vector<std::string_view> known;
    for (const auto& names : scene.light_names) known.insert(known.end(), names.begin(), names.end());
    text.fail(word, fmt::format("there is no light '{}'{}; the scene has {}, counted from 0", word.text,
                                nearest_hint(word.text, known), keys.size()));
  }
  for (const std::size_t light : lights) {
    if (keys[light] == 0) keys[light] = key;
  }
}

constexpr std::array<std::string_view, 4> kColors{"white", "red", "green", "blue"};

/// Index into kColors of the channel that stands out, or white.
std::size_t color_of(const render::Rgb& light) {
  constexpr float kWhite = 0.8f;  // the second channel is at least so much of the first
  std::size_t first = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (light[static_cast<int>(i)] > light[static_cast<int>(first)]) first = i;
  }
  float second = 0.0f;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i != first) second = std::max(second, light[static_cast<int>(i)]);
  }
  return second >= kWhite * light[static_cast<int>(first)] ? 0 : first + 1;
}

}  // namespace

/// Feelers to bright lights first; or to the lights that are named, in their order, and all others last.
SchemePtr make_light(const SchemeInput& input, SchemeText* arguments) {
  const render::SceneIndex& scene = input.scene;
  std::vector<Key> keys(scene.lights.size(), 0);
  if (arguments == nullptr) {
    constexpr LogScale kScale(-16, 16, 3);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = kScale.of(std::abs(render::grey(scene.lights[i].color)));
    return by_light(std::move(keys), kScale.count());
  }
  constexpr Key kMost = 1000;
  Key key = kMost;
  do {
    if (key == 0) arguments->fail(arguments->next(), fmt::format("more than {} lights", kMost));
    give_key(scene, *arguments, key--, keys);
    arguments->accept(',');
  } while (!arguments->next_is(')') && !arguments->at_end());
  // From 1 for the one named last.
  for (Key& of_light : keys) {
    if (of_light != 0) of_light -= key;
  }
  return by_light(std::move(keys), kMost - key + 1);
}

/// Feelers to near lights first.
SchemePtr make_light_distance(const SchemeInput& input, SchemeText*) {
  static constexpr LogScale kScale(-20, 30, 3);
  return feeler_scheme(
      kScale.count(), [lights = input.scene.lights](const RayTask& task, std::uint32_t light, const PackedRgb&) -> Key {
        if (light >= lights.size()) return 0;
        const double distance = render::reach_to(lights[light], task.origin);
        return kScale.count() - 1 - kScale.of(static_cast<float>(distance));
      });
}

/// Feelers by the colour of the light that they may take back, in the order that the user wants.
SchemePtr make_light_colour(const SchemeInput&, SchemeText* arguments) {
  const std::vector<std::uint32_t> ranks =
      arguments != nullptr ? read_ranks(*arguments, "a colour", kColors).of : std::vector<std::uint32_t>{0, 1, 2, 3};
  constexpr Key kCount = kColors.size();
  return feeler_scheme(kCount, [ranks](const RayTask&, std::uint32_t, const PackedRgb& at_stake) -> Key {
    return kCount - 1 - ranks[color_of(at_stake.unpack())];
  });
}

}  // namespace firstlight::priority
