#include "parser/expression/arithmetic.h"

#include <climits>

namespace firstlight::parser {

int to_int(double value) {
  const double whole = std::trunc(value);
  return whole >= INT_MIN && whole <= INT_MAX ? static_cast<int>(whole) : INT_MIN;
}

std::size_t picked_component(Keyword word) {
  switch (word) {
    case Keyword::x:
    case Keyword::u:
    case Keyword::red:
      return 0;
    case Keyword::y:
    case Keyword::v:
    case Keyword::green:
      return 1;
    case Keyword::z:
    case Keyword::blue:
      return 2;
    case Keyword::t:
    case Keyword::filter:
      return 3;
    case Keyword::transmit:
      return 4;
    case Keyword::gray:
      return kGray;
    default:
      return kNoComponent;
  }
}

}  // namespace firstlight::parser
