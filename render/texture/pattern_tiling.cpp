// Patterns that divide space into cells of few colours.

#include "render/texture/patterns.h"

#include <cmath>

namespace firstlight::render {
namespace {

/// Points this little below a border belong to the cell above it, so that a surface which lies on a border (a floor at
/// y = 0, say) is all in one layer of cells whatever the rounding of its hit points. [POV-Ray 3.7]
constexpr double kBorder = 1e-10;

class Checker final : public Pattern {
 public:
  double value(const Vec3& point) const override {
    const double cells = std::floor(point.x + kBorder) + std::floor(point.y + kBorder) + std::floor(point.z + kBorder);
    const double pairs = std::floor(0.5 * cells);
    return cells != 2.0 * pairs ? 1.0 : 0.0;
  }
};

}  // namespace

std::shared_ptr<const Pattern> make_checker() { return std::make_shared<Checker>(); }

}  // namespace firstlight::render
