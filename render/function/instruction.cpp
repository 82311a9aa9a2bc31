#include "render/function/instruction.h"

#include "render/function/operations.h"

namespace firstlight::render {

int operands(Operation operation) {
  if (operation <= Operation::local) return 0;
  if (operation < Operation::add) return 1;
  if (operation < Operation::select_negative) return 2;
  return operation == Operation::select_negative ? 3 : 4;
}

double apply(const Instruction& instruction, const double* a) {
  double result = instruction.value;
  switch (operands(instruction.operation)) {
    case 0:
      break;
    case 1:
      with_one(instruction, [&](auto f) { result = f(a[0]); });
      break;
    case 2:
      with_two(instruction.operation, [&](auto f) { result = f(a[0], a[1]); });
      break;
    case 3:
      result = select_negative(a[0], a[1], a[2]);
      break;
    default:
      result = select(a[0], a[1], a[2], a[3]);
      break;
  }
  return result;
}

}  // namespace firstlight::render
