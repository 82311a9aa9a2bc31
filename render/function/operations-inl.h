// The meaning of each operation over a lane type. Included once for each instruction set, so the guard switches back
// and forth.
#if defined(FIRSTLIGHT_RENDER_FUNCTION_OPERATIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FIRSTLIGHT_RENDER_FUNCTION_OPERATIONS_INL_H
#undef FIRSTLIGHT_RENDER_FUNCTION_OPERATIONS_INL_H
#else
#define FIRSTLIGHT_RENDER_FUNCTION_OPERATIONS_INL_H
#endif

#include "render/function/instruction.h"
#include "render/lanes/hyperbolic-inl.h"

#include <climits>
#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// As POV-Ray's processors cut numbers: what does not fit becomes the lowest integer.
template <class L>
HWY_INLINE L cut_to_integer(const L& value) {
  const L whole = trunc(value);
  return select((whole >= double{INT_MIN}) & (whole <= double{INT_MAX}), whole, L(double{INT_MIN}));
}

/// By the products that POV-Ray makes of it.
template <class L>
HWY_INLINE L whole_power(const L& x, int exponent) {
  const L square = x * x;
  switch (exponent) {
    case 2:
      return square;
    case 3:
      return square * x;
    case 4:
      return square * square;
    case 5:
      return square * square * x;
    case 6:
      return square * square * square;
    case 7:
      return square * square * x * square;
    default: {  // 8
      const L fourth = square * square;
      return fourth * fourth;
    }
  }
}

/// 1 where it holds, else 0.
template <class L>
HWY_INLINE L truth(const MaskOf<L>& mask) {
  return select(mask, L(1.0), L(0.0));
}

/// Does an operation with rows of numbers, which have room for a multiple of eight; `to` may be one of `from`. Pre: it
/// is no call, loop or parameter.
template <class L>
HWY_INLINE void operate(const Instruction& instruction, const double* const* from, double* to, std::size_t count) {
#define FIRSTLIGHT_EACH(operation, result)               \
  case Operation::operation:                             \
    for (std::size_t i = 0; i < count; i += L::kCount) { \
      const L a = L::load(from[0] + i);                  \
      L(result).store(to + i);                           \
    }                                                    \
    return;
#define FIRSTLIGHT_EACH_OF_TWO(operation, result)                 \
  case Operation::operation:                                      \
    for (std::size_t i = 0; i < count; i += L::kCount) {          \
      const L a = L::load(from[0] + i), b = L::load(from[1] + i); \
      L(result).store(to + i);                                    \
    }                                                             \
    return;
  const L value = instruction.value;
  switch (instruction.operation) {
    case Operation::constant:
      for (std::size_t i = 0; i < count; i += L::kCount) value.store(to + i);
      return;
      FIRSTLIGHT_EACH(add_constant, a + value)
      FIRSTLIGHT_EACH(multiply_constant, a * value)
      FIRSTLIGHT_EACH(whole_power, whole_power(a, instruction.index))
      FIRSTLIGHT_EACH(negate, -a)
      FIRSTLIGHT_EACH(logical_not, truth<L>(a == 0.0))
      FIRSTLIGHT_EACH(absolute, abs(a))
      FIRSTLIGHT_EACH(arc_cosine, arc_cosine(a))
      FIRSTLIGHT_EACH(hyperbolic_arc_cosine, hyperbolic_arc_cosine(a))
      FIRSTLIGHT_EACH(arc_sine, arc_sine(a))
      FIRSTLIGHT_EACH(hyperbolic_arc_sine, hyperbolic_arc_sine(a))
      FIRSTLIGHT_EACH(arc_tangent, arc_tangent(a))
      FIRSTLIGHT_EACH(hyperbolic_arc_tangent, hyperbolic_arc_tangent(a))
      FIRSTLIGHT_EACH(ceiling, -floor(-a))
      FIRSTLIGHT_EACH(cosine, cosine(a))
      FIRSTLIGHT_EACH(hyperbolic_cosine, hyperbolic_cosine(a))
      FIRSTLIGHT_EACH(exponential, exponential(a))
      FIRSTLIGHT_EACH(floor, floor(a))
      FIRSTLIGHT_EACH(integer, cut_to_integer(a))
      FIRSTLIGHT_EACH(natural_logarithm, logarithm(a))
      FIRSTLIGHT_EACH(logarithm, decimal_logarithm(a))
      FIRSTLIGHT_EACH(sine, sine(a))
      FIRSTLIGHT_EACH(hyperbolic_sine, hyperbolic_sine(a))
      FIRSTLIGHT_EACH(square, a * a)
      FIRSTLIGHT_EACH(square_root, sqrt(a))
      FIRSTLIGHT_EACH(tangent, tangent(a))
      FIRSTLIGHT_EACH(hyperbolic_tangent, hyperbolic_tangent(a))
      FIRSTLIGHT_EACH_OF_TWO(add, a + b)
      FIRSTLIGHT_EACH_OF_TWO(subtract, a - b)
      FIRSTLIGHT_EACH_OF_TWO(multiply, a * b)
      FIRSTLIGHT_EACH_OF_TWO(divide, a / b)
      FIRSTLIGHT_EACH_OF_TWO(power, power(a, b))
      FIRSTLIGHT_EACH_OF_TWO(arc_tangent_of_two, arc_tangent(a, b))
      FIRSTLIGHT_EACH_OF_TWO(integer_quotient, cut_to_integer(a / b))
      FIRSTLIGHT_EACH_OF_TWO(minimum, min(a, b))
      FIRSTLIGHT_EACH_OF_TWO(maximum, max(a, b))
      FIRSTLIGHT_EACH_OF_TWO(less, truth<L>(a < b))
      FIRSTLIGHT_EACH_OF_TWO(less_or_equal, truth<L>(a <= b))
      FIRSTLIGHT_EACH_OF_TWO(greater, truth<L>(a > b))
      FIRSTLIGHT_EACH_OF_TWO(greater_or_equal, truth<L>(a >= b))
      FIRSTLIGHT_EACH_OF_TWO(equal, truth<L>(a == b))
      FIRSTLIGHT_EACH_OF_TWO(not_equal, truth<L>(a != b))
      FIRSTLIGHT_EACH_OF_TWO(logical_and, truth<L>((a != 0.0) & (b != 0.0)))
      FIRSTLIGHT_EACH_OF_TWO(logical_or, truth<L>((a != 0.0) | (b != 0.0)))
    case Operation::remainder:
      for (std::size_t i = 0; i < count; ++i) to[i] = std::fmod(from[0][i], from[1][i]);
      return;
    case Operation::select_negative:
      for (std::size_t i = 0; i < count; i += L::kCount) {
        const L a = L::load(from[0] + i);
        select(a < 0.0, L::load(from[1] + i), L::load(from[2] + i)).store(to + i);
      }
      return;
    case Operation::select:
      for (std::size_t i = 0; i < count; i += L::kCount) {
        const L a = L::load(from[0] + i);
        const L not_below = select(a == 0.0, L::load(from[2] + i), L::load(from[3] + i));
        select(a < 0.0, L::load(from[1] + i), not_below).store(to + i);
      }
      return;
    default:
      return;
  }
#undef FIRSTLIGHT_EACH
#undef FIRSTLIGHT_EACH_OF_TWO
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#endif
