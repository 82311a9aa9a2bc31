#include "render/function/instruction.h"

#include "render/function/operations-inl.h"

namespace firstlight::render {

int operands(Operation operation) {
  if (operation <= Operation::local) return 0;
  if (operation < Operation::add) return 1;
  if (operation < Operation::select_negative) return 2;
  return operation == Operation::select_negative ? 3 : 4;
}

double apply(const Instruction& instruction, const double* a) {
  const double* const from[] = {a, a + 1, a + 2, a + 3};
  double result = instruction.value;
  HWY_NAMESPACE::operate<One>(instruction, from, &result, 1);
  return result;
}

}  // namespace firstlight::render
