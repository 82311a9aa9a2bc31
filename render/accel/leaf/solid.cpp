#include "render/accel/leaf/solid.h"

namespace firstlight::render {

namespace {

void add_blockers(const Solid& solid, std::vector<const Solid*>& blockers) {
  if (solid.kind == Solid::Kind::union_ && solid.clips().empty()) {
    for (const Solid& member : solid.members()) add_blockers(member, blockers);
  } else {
    blockers.push_back(&solid);
  }
}

}  // namespace

std::vector<const Solid*> blockers_of(const Solid& cramped) {
  std::vector<const Solid*> blockers;
  if (cramped.kind == Solid::Kind::shape && !cramped.shape->asks_box()) blockers.push_back(&cramped);
  if (cramped.kind == Solid::Kind::union_ && cramped.clips().empty()) add_blockers(cramped, blockers);
  return blockers;
}

}  // namespace firstlight::render
