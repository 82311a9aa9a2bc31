#include "app/compare/report/places.h"

#include <algorithm>
#include <cstdlib>

namespace firstlight::app::compare {
namespace {

constexpr int kSquare = 16;

Place place_at(const render::Picture& first, const render::Picture& second, int x, int y) {
  Place place{x, y, 0, {}, {}};
  const auto begin =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(first.width) + static_cast<std::size_t>(x));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    place.first[channel] = first.rgb[begin + channel];
    place.second[channel] = second.rgb[begin + channel];
    place.difference = std::max(place.difference, std::abs(place.first[channel] - place.second[channel]));
  }
  return place;
}

}  // namespace

std::vector<Place> worst_places(const render::Picture& first, const render::Picture& second, std::size_t most) {
  std::vector<Place> places;
  for (int top = 0; top < first.height; top += kSquare) {
    for (int left = 0; left < first.width; left += kSquare) {
      Place worst;
      for (int y = top; y < std::min(top + kSquare, first.height); ++y) {
        for (int x = left; x < std::min(left + kSquare, first.width); ++x) {
          const Place place = place_at(first, second, x, y);
          if (place.difference > worst.difference) worst = place;
        }
      }
      if (worst.difference > 0) places.push_back(worst);
    }
  }
  std::ranges::stable_sort(places, std::ranges::greater(), &Place::difference);
  places.resize(std::min(places.size(), most));
  return places;
}

}  // namespace firstlight::app::compare
