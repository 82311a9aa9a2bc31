#include "render/shape/superellipsoid_value.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/superellipsoid_value.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// x^y for x >= 0 and y > 0, with a relative error of some y 1e-16: much less than what counts as zero here.
template <class L>
HWY_INLINE L quick_power(const L& x, double y) {
  return exponential(logarithm(x) * y);
}

/// (a^e + b^e)^(1/e)
template <class L>
HWY_INLINE L norm(const L& a, const L& b, double e) {
  const L larger = max(a, b);
  const MaskOf<L> is_nothing = larger == 0.0;
  const L sum = 1.0 + quick_power(min(a, b) / select(is_nothing, L(1.0), larger), e);
  return select(is_nothing, L(0.0), select(sum != 1.0, larger * quick_power(sum, 1.0 / e), larger));
}

template <class L>
HWY_INLINE L value_at(const SuperellipsoidValue& form, const L& x, const L& y, const L& z) {
  return norm(norm(abs(x), abs(y), form.around), abs(z), form.along) - 1.0;
}

void values_along(const SuperellipsoidValue& form, const Ray& ray, const SuperellipsoidValue::Several& depths,
                  std::size_t count, SuperellipsoidValue::Several& values) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Lanes t = Lanes::load(&depths[i]);
    value_at<Lanes>(form, ray.origin.x + ray.direction.x * t, ray.origin.y + ray.direction.y * t,
                    ray.origin.z + ray.direction.z * t)
        .store(&values[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(values_along);

}  // namespace

double SuperellipsoidValue::at(const Vec3& point) const {
  return HWY_STATIC_DISPATCH(value_at)<One>(*this, point.x, point.y, point.z).v;
}

SuperellipsoidValue::Several SuperellipsoidValue::at(const Ray& ray, const Several& depths, std::size_t count) const {
  Several values;
  HWY_DYNAMIC_DISPATCH(values_along)(*this, ray, depths, count, values);
  return values;
}

}  // namespace firstlight::render
#endif
