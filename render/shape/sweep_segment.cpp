#include "render/shape/sweep_segment.h"

namespace firstlight::render {

Box3 SweepSegment::bounds() const {
  // Bezier's points of the curve: it stays between them, and so do its radii.
  std::array<SweepBall, 4> points = coefficients;
  const auto& c = coefficients;
  if (order == 1) {
    points[1] = c[0] + c[1];
  } else {
    points[1] = c[0] + c[1] * (1.0 / 3.0);
    points[2] = c[0] + c[1] * (2.0 / 3.0) + c[2] * (1.0 / 3.0);
    points[3] = c[0] + c[1] + c[2] + c[3];
  }
  Box3 box;
  for (std::size_t i = 0; i <= order; ++i) {
    const Vec3 reach(points[i].radius);
    box.extendBy(points[i].center - reach);
    box.extendBy(points[i].center + reach);
  }
  return box;
}

}  // namespace firstlight::render
