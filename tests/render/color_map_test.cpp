#include "render/surface/color_map_table.h"
#include "render/surface/compiled_pattern.h"
#include "tests/render/each_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace firstlight::render {
namespace {

/// The definition, one place after the other.
FilteredColor color_in(const ColorMap& map, double place) {
  const MapPlace found = place_in_map(place, static_cast<std::uint32_t>(map.size()),
                                      [&](std::uint32_t i) { return stored_position(map[i].position); });
  const FilteredColor& a = map[found.below].color;
  const FilteredColor& b = map[found.above].color;
  if (found.below == found.above) return b;
  const auto blend = [&](float from, float to) { return from + static_cast<float>((to - from) * found.fraction); };
  return {{blend(a.rgb.x, b.rgb.x), blend(a.rgb.y, b.rgb.y), blend(a.rgb.z, b.rgb.z)},
          blend(a.filter, b.filter),
          blend(a.transmit, b.transmit)};
}

bool are_same(const FilteredColor& a, const FilteredColor& b) {
  const auto same = [](float x, float y) { return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y); };
  return same(a.rgb.x, b.rgb.x) && same(a.rgb.y, b.rgb.y) && same(a.rgb.z, b.rgb.z) && same(a.filter, b.filter) &&
         same(a.transmit, b.transmit);
}

TEST(ColorMapTable, HasTheColoursOfTheMapAtEveryWidth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(-0.2, 1.2);
  std::uniform_real_distribution<float> channel(-1.0f, 2.0f);
  for (int round = 0; round < 300; ++round) {
    ColorMap map(static_cast<std::size_t>(1 + round % 9));
    for (ColorMapEntry& entry : map) {
      entry = {between(random),
               {{channel(random), channel(random), channel(random)}, channel(random), channel(random)}};
    }
    if (round % 3 != 0) std::ranges::sort(map, {}, &ColorMapEntry::position);
    if (round % 4 == 1 && map.size() > 2) map[1].position = map[2].position;
    const ColorMapTable table(map);
    Column<double> places;
    for (std::size_t i = 0; i < kRaysAtOnce; ++i) {
      const bool on_entry = random() % 4 == 0;
      places[i] = on_entry ? stored_position(map[random() % map.size()].position) : between(random);
    }
    places[7] = std::numeric_limits<double>::infinity();
    places[11] = -std::numeric_limits<double>::infinity();
    places[13] = std::numeric_limits<double>::quiet_NaN();
    for_each_target([&](const std::string& target) {
      ColorColumns colors;
      table.colors(places, kRaysAtOnce - 3, colors);
      for (std::size_t i = 0; i < kRaysAtOnce - 3; ++i) {
        ASSERT_TRUE(are_same(colors.color(i), color_in(map, places[i])))
            << target << " at " << places[i] << " in round " << round;
      }
    });
  }
}

}  // namespace
}  // namespace firstlight::render
