#include "render/trace/fog_share.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/trace/fog_share.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"
#include "render/math/noise-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Mean density of ground fog between two heights, in units of `altitude` above `offset`: it is 1 below 0 and 1/(1+y^2)
/// above, whose integral is atan(y).
template <class L>
HWY_INLINE L mean_density(const L& start, const L& end) {
  constexpr double kLevel = 1e-10;
  const L of_start = arc_tangent(start);
  const L of_end = arc_tangent(end);
  const L rise = start - end;
  L mean = select(abs(rise) > kLevel, (of_start - of_end) / rise, 1.0 / (start * start + 1.0));
  mean = select(end <= 0.0, (of_start - end) / rise, mean);
  mean = select(start <= 0.0, (of_end - start) / (end - start), mean);
  return select((start <= 0.0) & (end <= 0.0), L(1.0), mean);
}

template <class L>
HWY_INLINE L share_left(const Fog& fog, int generator, const Vec3Of<L>& origin, const Vec3Of<L>& direction,
                        const L& depth) {
  const bool is_ground = fog.type == Fog::kGround;
  const Vec3Of<L> end = origin + direction * depth;
  L density = 1.0;
  if (is_ground) {
    const auto up = everywhere<L>(fog.up);
    density = mean_density((dot(origin, up) - fog.offset) / fog.altitude, (dot(end, up) - fog.offset) / fog.altitude);
  }
  L way = depth;
  if (fog.turbulence) {
    const FogTurbulence& turbulent = *fog.turbulence;
    const Octaves octaves{turbulent.octaves, static_cast<float>(turbulent.lambda), static_cast<float>(turbulent.omega)};
    const Vec3Of<L> middle = is_ground ? (origin + end) * 0.5 : origin + direction * (depth / 2.0);
    const L strength = turbulence(middle * everywhere<L>(turbulent.amount), octaves, generator) * fog.turbulence_depth;
    // The longer the way, the more of the turbulence evens out.
    const L evenness = exponential(-depth / fog.distance);
    way = way * (1.0 - evenness * min(L(1.0), strength));
  }
  return exponential(-way * density / fog.distance);
}

void find_shares(const Fog& fog, int generator, std::size_t count, const Columns3<double>& origin,
                 const Columns3<double>& direction, const Column<double>& depth, Column<double>& share) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    store(share_left(fog, generator, load3<Lanes>(origin, i), load3<Lanes>(direction, i), load<Lanes>(depth, i)), share,
          i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_shares);

void find_fog_shares(const Fog& fog, int noise_generator, std::size_t count, const Columns3<double>& origin,
                     const Columns3<double>& direction, const Column<double>& depth, Column<double>& share) {
  HWY_DYNAMIC_DISPATCH(find_shares)(fog, noise_generator, count, origin, direction, depth, share);
}

double fog_share(const Fog& fog, int noise_generator, const Ray& ray, double depth) {
  const auto one = [](const Vec3& v) { return HWY_NAMESPACE::everywhere<One>(v); };
  return HWY_NAMESPACE::share_left(fog, noise_generator, one(ray.origin), one(ray.direction), One(depth)).v;
}

}  // namespace firstlight::render
#endif
