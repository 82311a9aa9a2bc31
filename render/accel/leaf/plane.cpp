#include "render/accel/leaf/plane.h"

#include <cmath>
#include <cstddef>

namespace firstlight::render {

void mark_coincident(std::span<PlaneLeaf> planes) {
  constexpr double kRoom = 1e-6;
  constexpr std::size_t kMany = 1000;  // so many are not compared with each other: all are in doubt
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes.size() > kMany) planes[i].in_doubt = true;
    for (std::size_t k = 0; k < i && planes.size() <= kMany; ++k) {
      PlaneLeaf& a = planes[i];
      PlaneLeaf& b = planes[k];
      const double side = a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
      const bool parallel = (a.normal - b.normal * side).length2() < kRoom * kRoom;
      const bool together = std::abs(a.offset - b.offset * side) <= kRoom * (1.0 + std::abs(a.offset));
      if (parallel && together) a.in_doubt = b.in_doubt = true;
    }
  }
}

}  // namespace firstlight::render
