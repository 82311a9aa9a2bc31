#include "render/math/unit_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/math/unit_columns.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

void make_unit_over_lanes(Columns3<double>& vectors, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const auto v = load3<Lanes>(vectors, i);
    const Lanes size = length(v);
    store3(select<Lanes>(size > 0.0, v * (Lanes(1.0) / size), v), vectors, i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(make_unit_over_lanes);

}  // namespace

void make_unit(Columns3<double>& vectors, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(make_unit_over_lanes)(vectors, count);
}

}  // namespace firstlight::render
#endif
