#pragma once

namespace firstlight::render {

/// `value` rounded to single precision, in which POV-Ray keeps some of the numbers that it computes with in double.
inline double in_single(double value) {
  float single = static_cast<float>(value);
#if defined(__GNUC__) && !defined(__clang__)
  // GCC 12 takes two such roundings side by side together, and leaves them out: it is not to see what becomes of them.
  __asm__("" : "+m"(single));
#endif
  return single;
}

}  // namespace firstlight::render
