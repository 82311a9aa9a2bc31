#include "render/texture/patterning.h"

#include <utility>

namespace firstlight::render {

Patterning patterned(PatternKind kind, PatternParameters parameters) {
  Patterning result;
  result.kind = kind;
  result.parameters = std::move(parameters);
  if (is_list(kind)) result.wave.frequency = 0.0;
  return result;
}

void gather(const Patterning& patterning, FeatureUses& uses) {
  if (!is_patterned(patterning.kind)) return;
  uses.add(patterning.unrendered);
  uses.add(patterning.warps.unrendered);
}

}  // namespace firstlight::render
