#include "render/shape/shape.h"

#include "render/shape/slots.h"

namespace firstlight::render {

void Shape::meet_block(const RayColumns& rays, std::uint64_t who, const DepthWindow* nearest_only, Slots& slots) const {
  thread_local std::vector<Crossing> list;
  SlotLists lists(*this, slots, true);
  for (; who != 0; who &= who - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(who));
    list.clear();
    if (nearest_only != nullptr) {
      nearest(rays.ray(i), nearest_only->low[i], nearest_only->high[i], list);
    } else {
      crossings(rays.ray(i), list);
    }
    for (const Crossing& crossing : list) lists.add(i, crossing.depth, crossing.face, crossing.place);
    if (slots.overflowed()) return;
  }
}

std::uint64_t Shape::inside_block(const Columns3<double>& points, std::uint64_t who) const {
  std::uint64_t holding = 0;
  for (; who != 0; who &= who - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(who));
    if (inside(points.vector(i))) holding |= std::uint64_t{1} << i;
  }
  return holding;
}

}  // namespace firstlight::render
