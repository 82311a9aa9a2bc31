#include "render/math/lattice_random.h"

#include "render/math/noise.h"

#include <array>
#include <random>

namespace firstlight::render {
namespace {

constexpr std::size_t kNumbers = 4100;  // as many as a hash and the two behind it ask for

}  // namespace

double table_random(unsigned index) {
  static const std::array<double, kNumbers> numbers = [] {
    std::array<double, kNumbers> result;
    std::mt19937 generator;
    for (double& number : result) number = static_cast<double>(generator()) / 4294967296.0;
    return result;
  }();
  return numbers[index];
}

unsigned cell_hash(double x, double y, double z) { return lattice_hash(x, y, z); }

Vec3 point_in_cell(const Vec3& corner) {
  const unsigned hash = cell_hash(corner.x, corner.y, corner.z);
  return corner + Vec3(table_random(hash), table_random(hash + 1), table_random(hash + 2));
}

}  // namespace firstlight::render
