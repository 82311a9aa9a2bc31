#include "render/film/antialias_grid.h"

#include <algorithm>
#include <cstddef>

namespace firstlight::render {
namespace {

// After so many rounds whatever may be needed is traced, so that no picture takes many more of them.
constexpr int kPatience = 4;

// Added up as POV-Ray does: the moves of the samples depend on the last bits.
std::vector<double> grid_offsets(int depth) {
  std::vector<double> offsets;
  const double step = 1.0 / depth;
  const double range = 0.5 - step * 0.5;
  for (double offset = -range; offset <= range + 1e-10; offset += step) offsets.push_back(offset);
  return offsets;
}

}  // namespace

GridSampling::GridSampling(const AntialiasSettings& settings, Film& film, PlaceSampler& sampler)
    : film_(film),
      contrast_(settings),
      jitter_(settings, settings.depth),
      sampler_(sampler),
      offsets_(grid_offsets(settings.depth)),
      edge_(static_cast<std::size_t>(film.width()) + static_cast<std::size_t>(film.height())),
      supersampled_(film.pixels()),
      has_grid_(film.pixels()) {
  make_blocks(settings.block_size);
}

void GridSampling::make_blocks(int block_size) {
  for (int y = 0; y < film_.height(); y += block_size) {
    for (int x = 0; x < film_.width(); x += block_size) {
      blocks_.push_back(
          {x, y, x + std::min(block_size, film_.width() - x), y + std::min(block_size, film_.height() - y)});
    }
  }
}

std::span<const SamplePoint> GridSampling::next() {
  collect();
  sampler_.clear();
  if (edge_asked_ < edge_.size()) {
    ask_for_edge();
  } else {
    if (wanted_end_ == wanted_.size()) decide();
    ask_for_grids();
  }
  const std::span<const SamplePoint> points = sampler_.begin();
  if (asked_ == Asked::grids && !sampler_.has_blur()) show_grids();
  return points;
}

void GridSampling::ask_for_edge() {
  asked_ = Asked::edge;
  const auto width = static_cast<std::size_t>(film_.width());
  for (; edge_asked_ < edge_.size() && sampler_.has_room(1); ++edge_asked_) {
    if (edge_asked_ < width) {
      const int x = static_cast<int>(edge_asked_);
      sampler_.add({static_cast<double>(x), -1.0}, pixel_at(x, 0));
    } else {
      const int y = static_cast<int>(edge_asked_ - width);
      sampler_.add({-1.0, static_cast<double>(y)}, pixel_at(0, y));
    }
  }
}

void GridSampling::ask_for_grids() {
  asked_ = Asked::grids;
  wanted_begin_ = wanted_end_;
  const std::size_t count = offsets_.size() * offsets_.size();
  for (; wanted_end_ < wanted_.size() && sampler_.has_room(count); ++wanted_end_) {
    const std::uint32_t pixel = wanted_[wanted_end_].pixel;
    const double x = pixel % static_cast<std::uint32_t>(film_.width());
    const double y = pixel / static_cast<std::uint32_t>(film_.width());
    for (const double dy : offsets_) {
      for (const double dx : offsets_) sampler_.add(jitter_.move({x + dx, y + dy}), pixel);
    }
  }
}

void GridSampling::show_grids() {
  const auto count = static_cast<std::uint32_t>(offsets_.size() * offsets_.size());
  std::uint32_t first = film_.pixels();
  for (std::size_t i = wanted_begin_; i < wanted_end_; ++i, first += count) {
    if (wanted_[i].sure) film_.average(wanted_[i].pixel, first, count);
  }
}

void GridSampling::collect() {
  if (asked_ == Asked::edge) {
    const std::size_t first = edge_asked_ - sampler_.size();
    for (std::uint32_t i = 0; i < sampler_.size(); ++i) edge_[first + i] = sampler_.color(i);
  }
  if (asked_ != Asked::grids) return;
  const std::size_t count = offsets_.size() * offsets_.size();
  std::uint32_t sample = 0;
  for (std::size_t i = wanted_begin_; i < wanted_end_; ++i) {
    const auto [pixel, sure] = wanted_[i];
    PixelColor sum = sampler_.pixel_color(pixel);
    for (std::size_t k = 0; k < count; ++k) sum += sampler_.color(sample++);
    supersampled_[pixel] = mean_of(sum, static_cast<double>(count + 1));
    has_grid_[pixel] = true;
    if (sure) film_.refine(pixel, supersampled_[pixel], 0.0f);
  }
}

void GridSampling::decide() {
  wanted_.clear();
  wanted_end_ = 0;
  const bool guess = ++decisions_ > kPatience;
  std::erase_if(blocks_, [&](const Block& block) { return decide(block, guess); });
}

void GridSampling::look_at(const Block& block) {
  const auto width = static_cast<std::size_t>(film_.width());
  const int columns = block.right - block.left + 1;
  const int rows = block.bottom - block.top + 1;
  encoded_.clear();
  for (int y = block.top - 1; y < block.bottom; ++y) {
    for (int x = block.left - 1; x < block.right; ++x) {
      if (x < 0 && y < 0) {
        encoded_.emplace_back();  // nothing is compared with the corner
      } else if (y < 0) {
        encoded_.push_back(contrast_.encode(edge_[static_cast<std::size_t>(x)]));
      } else if (x < 0) {
        encoded_.push_back(contrast_.encode(edge_[width + static_cast<std::size_t>(y)]));
      } else {
        encoded_.push_back(contrast_.encode(sampler_.pixel_color(pixel_at(x, y))));
      }
    }
  }
  answers_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Answer::no);
}

// Whether the pixel of `from` differs from a neighbour as that is when `from` is looked at. `pixel`: the neighbour, if
// it may have a grid.
GridSampling::Answer GridSampling::differs(std::size_t cell, std::optional<std::uint32_t> pixel,
                                           std::size_t from) const {
  const auto compare = [&](const PixelColor& encoded) {
    return contrast_.between(encoded, encoded_[from]) ? Answer::yes : Answer::no;
  };
  const Answer without_grid = compare(encoded_[cell]);
  if (!pixel || answers_[cell] == Answer::no) return without_grid;
  if (!has_grid_[*pixel]) return Answer::unknown;
  const Answer with_grid = compare(contrast_.encode(supersampled_[*pixel]));
  return answers_[cell] == Answer::yes || with_grid == without_grid ? with_grid : Answer::unknown;
}

bool GridSampling::decide(const Block& block, bool guess) {
  look_at(block);
  const auto stride = static_cast<std::size_t>(block.right - block.left + 1);
  const auto cell_of = [&](int x, int y) {
    return static_cast<std::size_t>(y - block.top + 1) * stride + static_cast<std::size_t>(x - block.left + 1);
  };
  for (int y = block.top; y < block.bottom; ++y) {
    for (int x = block.left; x < block.right; ++x) {
      const std::size_t here = cell_of(x, y);
      Answer answer = Answer::no;
      const auto compare_with = [&](std::size_t cell, std::optional<std::uint32_t> pixel) {
        const Answer difference = differs(cell, pixel, here);
        if (answer != Answer::yes && difference != Answer::no) answer = difference;
      };
      const auto left = x > block.left ? std::optional(pixel_at(x - 1, y)) : std::nullopt;
      const auto above = y > block.top ? std::optional(pixel_at(x, y - 1)) : std::nullopt;
      compare_with(here - 1, left);
      compare_with(here - stride, above);
      answers_[here] = answer;
      // A neighbour that has no grid yet gets one; if it has one already, it has one.
      if (left && contrast_.between(encoded_[here - 1], encoded_[here])) answers_[here - 1] = Answer::yes;
      if (above && contrast_.between(encoded_[here - stride], encoded_[here])) answers_[here - stride] = Answer::yes;
    }
  }
  bool decided = true;
  for (int y = block.top; y < block.bottom; ++y) {
    for (int x = block.left; x < block.right; ++x) {
      const std::uint32_t pixel = pixel_at(x, y);
      const Answer answer = answers_[cell_of(x, y)];
      if (answer == Answer::no) {
        sampler_.settle(pixel);
      } else if (answer == Answer::yes && has_grid_[pixel]) {
        film_.refine(pixel, supersampled_[pixel], 0.0f);
      } else {
        decided = false;
        const bool sure = answer == Answer::yes;
        if (!has_grid_[pixel] && (sure || guess)) wanted_.push_back({pixel, sure});
      }
    }
  }
  return decided;
}

}  // namespace firstlight::render
