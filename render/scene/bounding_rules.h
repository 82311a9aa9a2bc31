#pragma once

namespace firstlight::render {

/// Which of the bounds that a scene gives its objects count.
struct BoundingRules {
  bool remove_bounds = true;  ///< not those of single shapes at top level
  bool split_unions = false;  ///< not those of unions at top level whose members are finite
};

}  // namespace firstlight::render
