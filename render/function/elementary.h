#pragma once

#include "render/function/instruction.h"

#include <cstddef>

namespace firstlight::render {

/// Elementary functions of rows of numbers: results replace those of `a`. Both rows have room for a
/// multiple of eight numbers. `b` matters to operations of two. False, and nothing done, for an operation of another kind.
bool evaluate_elementary(Operation operation, double* a, const double* b, std::size_t count);

}  // namespace firstlight::render
