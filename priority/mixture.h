#pragma once

#include "priority/schemes.h"

#include <vector>

namespace firstlight::priority {

/// A member of a mixture, with its weight.
struct WeightedMember {
  SchemePtr scheme;
  double weight = 1.0;  ///< negative: its last rays become its first
};

/// The first member decides, each further one orders what is equal before it. Pre: at least one.
SchemePtr make_lexicographic(std::vector<SchemePtr> members);
/// By the sum of weight * key, the keys of each member being spread over 0 to 1. Pre: at least one.
SchemePtr make_weighted(std::vector<WeightedMember> members);

}  // namespace firstlight::priority
