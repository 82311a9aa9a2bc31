#include "render/image/difference.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

/// Not-a-number fails every comparison, so it becomes black.
double shown(float channel) { return channel > 0.0f ? std::min(channel, 1.0f) : 0.0; }

double difference(const Rgb& a, const Rgb& b) {
  return std::abs(shown(a.x) - shown(b.x)) + std::abs(shown(a.y) - shown(b.y)) + std::abs(shown(a.z) - shown(b.z));
}

}  // namespace

double mean_absolute_difference(std::span<const Rgb> a, std::span<const Rgb> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += difference(a[i], b[i]);
  return a.empty() ? 0.0 : sum / (3.0 * static_cast<double>(a.size()));
}

RemainingDifference::RemainingDifference(std::span<const Rgb> finished) : finished_(finished), black_(0.0) {
  for (const Rgb& color : finished) black_ += difference(color, Rgb(0.0f));
  if (!finished.empty()) black_ /= 3.0 * static_cast<double>(finished.size());
}

double RemainingDifference::operator()(std::span<const Rgb> picture) const {
  const double apart = mean_absolute_difference(picture, finished_);
  if (black_ == 0.0) return apart == 0.0 ? 0.0 : 1.0;
  return apart / black_;
}

}  // namespace firstlight::render
