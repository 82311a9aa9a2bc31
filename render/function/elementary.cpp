#include "render/function/elementary.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/elementary.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/hyperbolic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

void elementary_row(Operation operation, double* a, const double* b, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Lanes::kCount) {
    const Lanes x = Lanes::load(a + i);
    Lanes result = x;
    switch (operation) {
      case Operation::arc_cosine:
        result = arc_cosine(x);
        break;
      case Operation::arc_sine:
        result = arc_sine(x);
        break;
      case Operation::arc_tangent:
        result = arc_tangent(x);
        break;
      case Operation::cosine:
        result = cosine(x);
        break;
      case Operation::exponential:
        result = exponential(x);
        break;
      case Operation::natural_logarithm:
        result = logarithm(x);
        break;
      case Operation::sine:
        result = sine(x);
        break;
      case Operation::tangent:
        result = tangent(x);
        break;
      case Operation::power:
        result = power(x, Lanes::load(b + i));
        break;
      case Operation::arc_tangent_of_two:
        result = arc_tangent(x, Lanes::load(b + i));
        break;
      default:
        break;
    }
    result.store(a + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(elementary_row);

bool evaluate_elementary(Operation operation, double* a, const double* b, std::size_t count) {
  switch (operation) {
    case Operation::arc_cosine:
    case Operation::arc_sine:
    case Operation::arc_tangent:
    case Operation::cosine:
    case Operation::exponential:
    case Operation::natural_logarithm:
    case Operation::sine:
    case Operation::tangent:
    case Operation::power:
    case Operation::arc_tangent_of_two:
      HWY_DYNAMIC_DISPATCH(elementary_row)(operation, a, b, count);
      return true;
    default:
      return false;
  }
}

}  // namespace firstlight::render
#endif
