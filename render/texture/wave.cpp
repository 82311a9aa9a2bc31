#include "render/texture/wave.h"

#include "render/math/single.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture/wave.cpp"
#include <hwy/foreach_target.h>

#include "render/texture/wave-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

void shape_block(const Wave& wave, std::size_t count, Column<double>& values) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) store(shaped(wave, load<Lanes>(values, i)), values, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {
namespace {

HWY_EXPORT(shape_block);

}  // namespace

void shape_all(const Wave& wave, std::size_t count, Column<double>& values) {
  // POV-Ray keeps the numbers of waves in single precision, and computes with them in double.
  const Wave kept{wave.form, in_single(wave.exponent), in_single(wave.frequency), in_single(wave.phase)};
  HWY_DYNAMIC_DISPATCH(shape_block)(kept, count, values);
}

}  // namespace firstlight::render
#endif
