#include "render/light/arrival.h"

#include <algorithm>

namespace firstlight::render {

/// All directions alike.
void beam::everywhere(const Light&, const Columns3<double>&, std::size_t count, Arrival& arrival) {
  std::fill_n(arrival.share.at.begin(), count, 1.0);
}

}  // namespace firstlight::render
