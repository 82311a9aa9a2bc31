#include "render/film/antialias_halving.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace firstlight::render {
namespace {

// At most this many cells wait before the smallest ones are finished first, so that memory stays bounded.
constexpr std::size_t kMostCells = std::size_t{1} << 22;

template <class Corners>
PixelColor mean_of(const Corners& corners) {
  return (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0f;
}

}  // namespace

Halving::Halving(const AntialiasSettings& settings, Film& film, PlaceSampler& sampler)
    : film_(film),
      contrast_(settings),
      jitter_(settings, (1 << settings.depth) + 1),
      sampler_(sampler),
      side_(1u << settings.depth),
      edge_(static_cast<std::size_t>(film.width()) + static_cast<std::size_t>(film.height()) + 1),
      levels_(static_cast<std::size_t>(settings.depth - 1)) {}

std::span<const SamplePoint> Halving::next() {
  if (!pixels_looked_at_) {
    collect_edge();
    sampler_.clear();
    if (edge_asked_ < edge_.size()) {
      ask_for_edge();
      return sampler_.begin();
    }
    look_at_pixels();
  } else {
    collect_middles();
  }
  sampler_.clear();
  ask_for_middles();
  return sampler_.begin();
}

void Halving::ask_for_edge() {
  const auto height = static_cast<std::size_t>(film_.height());
  for (; edge_asked_ < edge_.size() && sampler_.has_room(1); ++edge_asked_) {
    PicturePoint corner;
    if (edge_asked_ <= height) {
      corner = {static_cast<double>(film_.width()), static_cast<double>(edge_asked_)};
    } else {
      corner = {static_cast<double>(edge_asked_ - height - 1), static_cast<double>(height)};
    }
    const auto x = std::min(static_cast<std::uint32_t>(corner.x), static_cast<std::uint32_t>(film_.width() - 1));
    const auto y = std::min(static_cast<std::uint32_t>(corner.y), static_cast<std::uint32_t>(film_.height() - 1));
    sampler_.add({corner.x - 0.5, corner.y - 0.5}, y * static_cast<std::uint32_t>(film_.width()) + x);
  }
}

void Halving::collect_edge() {
  const std::size_t first = edge_asked_ - sampler_.size();
  for (std::uint32_t i = 0; i < sampler_.size(); ++i) edge_[first + i] = sampler_.color(i);
}

bool Halving::differ(const Corners& encoded) const {
  for (std::size_t i = 0; i < encoded.size(); ++i) {
    for (std::size_t j = i + 1; j < encoded.size(); ++j) {
      if (contrast_.between(encoded[i], encoded[j])) return true;
    }
  }
  return false;
}

void Halving::look_at_pixels() {
  pixels_looked_at_ = true;
  const auto width = static_cast<std::uint32_t>(film_.width());
  const auto height = static_cast<std::uint32_t>(film_.height());
  // Corners along the upper and the lower side of a row of pixels, as they are and as they are compared.
  struct Row {
    std::vector<PixelColor> colors;
    std::vector<PixelColor> encoded;
  };
  const auto row_at = [&](std::uint32_t y) {
    Row row;
    for (std::uint32_t x = 0; x <= width; ++x) {
      row.colors.push_back(x == width    ? edge_[y]
                           : y == height ? edge_[std::size_t{height} + 1 + x]
                                         : sampler_.pixel_color(y * width + x));
      row.encoded.push_back(contrast_.encode(row.colors.back()));
    }
    return row;
  };
  Row upper = row_at(0);
  for (std::uint32_t y = 0; y < height; ++y) {
    Row lower = row_at(y + 1);
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t pixel = y * width + x;
      const Corners corners{upper.colors[x], upper.colors[x + 1], lower.colors[x], lower.colors[x + 1]};
      const bool open =
          !levels_.empty() && differ({upper.encoded[x], upper.encoded[x + 1], lower.encoded[x], lower.encoded[x + 1]});
      if (open) levels_.front().cells.push_back({pixel, 0, 0, corners});
      film_.refine(pixel, mean_of(corners), open ? 1.0f : 0.0f);
    }
    upper = std::move(lower);
  }
}

// Breadth first, unless too much waits.
std::size_t Halving::level_to_do() const {
  std::size_t waiting = 0;
  std::size_t shallowest = levels_.size();
  std::size_t deepest = levels_.size();
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    if (levels_[i].open() == 0) continue;
    waiting += levels_[i].open();
    if (shallowest == levels_.size()) shallowest = i;
    deepest = i;
  }
  return waiting > kMostCells ? deepest : shallowest;
}

void Halving::ask_for_middles() {
  middles_.clear();
  level_ = level_to_do();
  if (level_ == levels_.size()) return;
  const Level& level = levels_[level_];
  const std::uint32_t step = side_ >> level_;
  const std::uint32_t half = step / 2;
  places_.begin(std::min<std::size_t>(film_.room(), 5 * level.open()));
  for (std::size_t i = level.begin; i < level.cells.size() && sampler_.has_room(5); ++i) {
    const Cell& cell = level.cells[i];
    middles_.push_back({sample_at(cell, half, 0), sample_at(cell, 0, half), sample_at(cell, half, half),
                        sample_at(cell, step, half), sample_at(cell, half, step)});
  }
}

// The sample at a place in a cell, given in finest steps from its upper left corner.
std::uint32_t Halving::sample_at(const Cell& cell, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t column = cell.pixel % static_cast<std::uint32_t>(film_.width());
  const std::uint32_t row = cell.pixel / static_cast<std::uint32_t>(film_.width());
  const double step = 1.0 / side_;
  std::uint32_t& sample = places_.at(column * side_ + cell.x + x, row * side_ + cell.y + y);
  if (sample == PlaceTable::kNone) {
    sample =
        sampler_.add(jitter_.move({column - 0.5 + (cell.x + x) * step, row - 0.5 + (cell.y + y) * step}), cell.pixel);
  }
  return sample;
}

void Halving::collect_middles() {
  if (level_ == levels_.size()) return;
  Level& level = levels_[level_];
  const auto half = static_cast<std::uint16_t>((side_ >> level_) / 2);
  const bool may_go_on = level_ + 1 < levels_.size();
  const float weight = std::ldexp(1.0f, -2 * static_cast<int>(level_));
  for (const Middles& middles : middles_) {
    const Cell& cell = level.cells[level.begin++];
    const auto& [upper_left, upper_right, lower_left, lower_right] = cell.corners;
    const PixelColor top = sampler_.color(middles.top);
    const PixelColor left = sampler_.color(middles.left);
    const PixelColor middle = sampler_.color(middles.middle);
    const PixelColor right = sampler_.color(middles.right);
    const PixelColor bottom = sampler_.color(middles.bottom);
    const std::array<Corners, 4> quarters{
        Corners{upper_left, top, left, middle}, Corners{top, upper_right, middle, right},
        Corners{left, middle, lower_left, bottom}, Corners{middle, right, bottom, lower_right}};
    PixelColor color = film_.refined_color(cell.pixel) - mean_of(cell.corners) * weight;
    float open = film_.open_share(cell.pixel) - weight;
    for (std::size_t i = 0; i < quarters.size(); ++i) {
      const Corners& corners = quarters[i];
      color += mean_of(corners) * (weight / 4.0f);
      if (!may_go_on) continue;
      Corners encoded;
      for (std::size_t k = 0; k < corners.size(); ++k) encoded[k] = contrast_.encode(corners[k]);
      if (!differ(encoded)) continue;
      open += weight / 4.0f;
      levels_[level_ + 1].cells.push_back({cell.pixel, static_cast<std::uint16_t>(cell.x + (i % 2) * half),
                                           static_cast<std::uint16_t>(cell.y + (i / 2) * half), corners});
    }
    film_.refine(cell.pixel, color, open);
  }
  if (level.open() == 0) {
    level.cells.clear();
    level.begin = 0;
  }
}

}  // namespace firstlight::render
