#include "render/texture/finish.h"

namespace firstlight::render {

void gather(const Finish& finish, FeatureUses& uses) {
  for (const FeatureUse& use : finish.unrendered.list()) {
    const bool nothing = (use.feature == Feature::crand && finish.crand == 0.0) ||
                         (use.feature == Feature::irid && finish.irid == 0.0) ||
                         (use.feature == Feature::caustics && finish.legacy_caustics <= 0.0);
    if (!nothing) uses.add(use);
  }
}

}  // namespace firstlight::render
