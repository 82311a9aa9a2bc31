#include "render/film/preview.h"

#include "render/math/pixel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace firstlight::render {
namespace {

/// How far a pixel is off, on average, for each unit of the bound on what it misses. Measured on scenes of mirrors and
/// glass: 0.04 to 0.06. It only decides when a pixel's own light looks better than its neighbours'.
constexpr float kErrorOfBound = 0.05f;
/// The same for what is interpolated between neighbours, for each unit of contrast between them.
constexpr float kErrorOfContrast = 0.25f;

const Rgb& light_of(const Rgb& color) { return color; }
const Rgb& light_of(const PixelColor& pixel) { return pixel.light; }
float clear_of(const Rgb&) { return 0.0f; }
float clear_of(const PixelColor& pixel) { return pixel.clear; }

/// Fills a picture of Rgb or PixelColor grid by grid, keeping for each pixel how far it may be off.
template <class Color>
class HoleFilling {
 public:
  explicit HoleFilling(const Film& film)
      : film_(film), width_(film.width()), height_(film.height()), picture_(film.pixels()), error_(picture_.size()) {
    const auto width = static_cast<std::size_t>(width_);
    for (int y = 0; y < height_; ++y) film.row(y, std::span(picture_).subspan(index(0, y), width));
  }

  std::vector<Color> run() {
    visit_grid(kCoarsestGrid, 0, [this](int x, int y) { error_[index(x, y)] = own_error(x, y); });
    for (int stride = kCoarsestGrid / 2; stride > 0; stride /= 2) {
      visit_grid(stride, 2 * stride, [this, stride](int x, int y) {
        const Guess guess = between(x, y, stride);
        const float own = film_.is_lit(x, y) ? own_error(x, y) : INFINITY;
        if (own <= guess.error) {
          error_[index(x, y)] = own;
        } else {
          error_[index(x, y)] = guess.error;
          picture_[index(x, y)] = guess.color;
        }
      });
    }
    return std::move(picture_);
  }

 private:
  struct Guess {
    Color color;
    float error;
  };

  /// The points of a grid but for those of a coarser one, if there is one.
  template <class Visit>
  void visit_grid(int stride, int coarser, const Visit& visit) {
    for (int y = 0; y < height_; y += stride) {
      for (int x = 0; x < width_; x += stride) {
        if (coarser == 0 || x % coarser != 0 || y % coarser != 0) visit(x, y);
      }
    }
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  float own_error(int x, int y) const { return kErrorOfBound * static_cast<float>(film_.outstanding(x, y)); }

  /// From the two or four points of the coarser grid around (x, y), as far as they are in the picture.
  Guess between(int x, int y, int stride) const {
    const int dx = x % (2 * stride) == 0 ? 0 : stride;
    const int dy = y % (2 * stride) == 0 ? 0 : stride;
    Color sum(Rgb(0.0f));
    Rgb least(INFINITY);
    Rgb most(-INFINITY);
    float least_clear = INFINITY;
    float most_clear = -INFINITY;
    float error = 0.0f;
    float count = 0.0f;
    for (const int ny : {y - dy, y + dy}) {
      for (const int nx : {x - dx, x + dx}) {
        if (nx >= width_ || ny >= height_) continue;
        const Color& color = picture_[index(nx, ny)];
        sum += color;
        error += error_[index(nx, ny)];
        count += 1.0f;
        for (unsigned c = 0; c < 3; ++c) {
          least[c] = std::min(least[c], light_of(color)[c]);
          most[c] = std::max(most[c], light_of(color)[c]);
        }
        least_clear = std::min(least_clear, clear_of(color));
        most_clear = std::max(most_clear, clear_of(color));
      }
    }
    const float contrast = std::max(max_component(most - least), most_clear - least_clear);
    return {sum / count, error / count + kErrorOfContrast * contrast};
  }

  const Film& film_;
  const int width_;
  const int height_;
  std::vector<Color> picture_;
  std::vector<float> error_;
};

}  // namespace

std::vector<Rgb> preview(const Film& film) { return HoleFilling<Rgb>(film).run(); }

std::vector<PixelColor> preview_with_alpha(const Film& film) { return HoleFilling<PixelColor>(film).run(); }

}  // namespace firstlight::render
