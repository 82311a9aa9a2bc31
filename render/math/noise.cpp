#include "render/math/noise.h"

#include "render/math/noise-inl.h"

namespace firstlight::render {
namespace {

using PointOfOne = HWY_NAMESPACE::Vec3Of<One>;

PointOfOne of_one(const Vec3& p) { return {p.x, p.y, p.z}; }
Vec3 vector(const PointOfOne& p) { return {p.x.v, p.y.v, p.z.v}; }

}  // namespace

unsigned lattice_hash(double x, double y, double z) {
  const auto whole = [](double c) {
    const double cut = HWY_NAMESPACE::cut(One(c)).v;
    return static_cast<unsigned>(static_cast<int>(cut)) & (LatticeTables::kPoints - 1);
  };
  const auto& permutation = LatticeTables::get().permutation;
  return permutation[permutation[permutation[whole(x)] ^ whole(y)] ^ whole(z)];
}

double noise(const Vec3& point, int generator) { return HWY_NAMESPACE::noise(of_one(point), generator).v; }
Vec3 dnoise(const Vec3& point) { return vector(HWY_NAMESPACE::dnoise(of_one(point))); }
double turbulence(const Vec3& point, const Octaves& octaves, int generator) {
  return HWY_NAMESPACE::turbulence(of_one(point), octaves, generator).v;
}
Vec3 dturbulence(const Vec3& point, const Octaves& octaves) {
  return vector(HWY_NAMESPACE::dturbulence(of_one(point), octaves));
}

}  // namespace firstlight::render
