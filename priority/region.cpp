#include "priority/order.h"
#include "priority/pixels.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>

namespace firstlight::priority {
namespace {

constexpr std::size_t kMost = 256;

std::string written(const Rectangle& r) { return fmt::format("{},{},{},{}", r.left, r.top, r.right, r.bottom); }

bool overlap(const Rectangle& a, const Rectangle& b) {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

/// By the rectangle of the picture that a ray's pixel lies in, the first before the second and so on; the rest last.
/// Source   Yagel & Meeker 1997, section 4, "region".
class Region final : public Scheme {
 public:
  Region(const SchemeInput& input, std::vector<Rectangle> rectangles)
      : pixels_(input), rectangles_(std::move(rectangles)) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = key(pixels_.place(tasks[i]));
  }
  Key key_count() const override { return static_cast<Key>(rectangles_.size()) + 1; }

 private:
  Key key(const Pixels::Place& at) const {
    Key key = static_cast<Key>(rectangles_.size());
    for (const Rectangle& r : rectangles_) {
      if (at.x >= r.left && at.x <= r.right && at.y >= r.top && at.y <= r.bottom) return key;
      --key;
    }
    return 0;
  }

  Pixels pixels_;
  std::vector<Rectangle> rectangles_;
};

std::vector<Rectangle> read_rectangles(SchemeText& text) {
  std::vector<Rectangle> rectangles;
  do {
    Piece place = text.next();
    int numbers[4];
    for (int& number : numbers) {
      number = text.integer("a pixel's coordinate");
      text.accept(',');
    }
    const Rectangle rectangle{numbers[0], numbers[1], numbers[2], numbers[3]};
    if (rectangle.left > rectangle.right || rectangle.top > rectangle.bottom) {
      text.fail(place, fmt::format("the rectangle {} is empty: the upper left pixel comes first", written(rectangle)));
    }
    for (const Rectangle& other : rectangles) {
      if (!overlap(rectangle, other)) continue;
      text.fail(place, fmt::format("the rectangle {} overlaps {}", written(rectangle), written(other)));
    }
    if (rectangles.size() == kMost) text.fail(place, fmt::format("more than {} rectangles", kMost));
    rectangles.push_back(rectangle);
  } while (!text.next_is(')') && !text.at_end());
  return rectangles;
}

}  // namespace

SchemePtr make_region(const SchemeInput& input, SchemeText* arguments) {
  if (arguments != nullptr) return std::make_shared<Region>(input, read_rectangles(*arguments));
  // Half of the picture on each side, in the middle: where people look first.
  const Rectangle middle{input.width / 4, input.height / 4, input.width - 1 - input.width / 4,
                         input.height - 1 - input.height / 4};
  return std::make_shared<Region>(input, std::vector<Rectangle>{middle});
}

}  // namespace firstlight::priority
