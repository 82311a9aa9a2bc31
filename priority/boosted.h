#pragma once

#include "priority/order.h"

#include <memory>
#include <vector>

namespace firstlight::priority {

/// A scheme with boosts above it: rays leave by the sum of their boosts, and by the scheme where the sums are equal.
/// Pre: the boosts are right for the input's scene.
std::shared_ptr<const Scheme> make_boosted(std::shared_ptr<const Scheme> base, const std::vector<Boost>& boosts,
                                           const SchemeInput& input);

}  // namespace firstlight::priority
