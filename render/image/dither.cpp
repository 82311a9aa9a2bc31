#include "render/image/dither.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>
#include <utility>

namespace firstlight::render {
namespace {

struct Name {
  std::string_view name;
  Dithering method;
};

constexpr Name kNames[] = {{"B2", Dithering::bayer2},     {"B3", Dithering::bayer3},
                           {"B4", Dithering::bayer4},     {"D1", Dithering::diffusion1},
                           {"D2", Dithering::diffusion2}, {"FS", Dithering::floyd_steinberg}};

/// Ranks from 1, by column and row.
constexpr int kBayer2[2][2] = {{1, 3}, {4, 2}};
constexpr int kBayer3[3][3] = {{3, 7, 4}, {6, 1, 9}, {2, 8, 5}};
constexpr int kBayer4[4][4] = {{1, 9, 3, 11}, {13, 5, 15, 7}, {4, 12, 2, 10}, {16, 8, 14, 6}};

template <std::size_t size>
float offset_of(const int (&ranks)[size][size], std::size_t x, std::size_t y) {
  return static_cast<float>(ranks[x % size][y % size] / static_cast<double>(size * size) - 0.5);
}

}  // namespace

std::optional<Dithering> find_dithering(std::string_view name) {
  std::string upper(name);
  std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const auto* const found = std::ranges::find(kNames, upper, &Name::name);
  return found == std::end(kNames) ? std::nullopt : std::optional(found->method);
}

// One place more on either side, for what leaves the row.
Ditherer::Ditherer(Dithering method, int width)
    : method_(method), row_(static_cast<std::size_t>(width) + 2), next_(row_.size()) {}

ChannelOffsets Ditherer::before(std::size_t x) {
  switch (method_) {
    case Dithering::diffusion1:
      return std::exchange(row_[0], ChannelOffsets{});
    case Dithering::diffusion2:
    case Dithering::floyd_steinberg:
      return row_[x + 1];
    default:
      return {};
  }
}

float Ditherer::before_rounding(std::size_t x, std::size_t y) const {
  switch (method_) {
    case Dithering::bayer2:
      return offset_of(kBayer2, x, y);
    case Dithering::bayer3:
      return offset_of(kBayer3, x, y);
    case Dithering::bayer4:
      return offset_of(kBayer4, x, y);
    default:
      return 0.0f;
  }
}

inline void Ditherer::add(std::vector<ChannelOffsets>& row, std::size_t place, const ChannelOffsets& error,
                          float share) {
  for (std::size_t c = 0; c < error.size(); ++c) row[place][c] += error[c] * share;
}

// A row begins when its first pixel is done, so that this one gets what the row before handed on to itself. [POV-Ray
// 3.7]
void Ditherer::hand_on(std::size_t x, const ChannelOffsets& error) {
  if (method_ == Dithering::diffusion1) {
    row_[0] = error;
    return;
  }
  if (method_ != Dithering::diffusion2 && method_ != Dithering::floyd_steinberg) return;
  if (x == 0) {
    std::swap(row_, next_);
    std::ranges::fill(next_, ChannelOffsets{});
  }
  const std::size_t here = x + 1;
  if (method_ == Dithering::diffusion2) {
    add(row_, here + 1, error, 2 / 4.0f);
    add(next_, here, error, 1 / 4.0f);
    add(next_, here + 1, error, 1 / 4.0f);
  } else {
    add(row_, here + 1, error, 7 / 16.0f);
    add(next_, here - 1, error, 3 / 16.0f);
    add(next_, here, error, 5 / 16.0f);
    add(next_, here + 1, error, 1 / 16.0f);
  }
}

}  // namespace firstlight::render
