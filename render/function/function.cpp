#include "render/function/function.h"

#include <algorithm>
#include <array>

namespace firstlight::render {

void Function::evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                             Evaluation& evaluation) const {
  std::array<double, kMostParameters> point;
  std::array<double, kMostResults> values;
  const std::uint64_t steps = evaluation.steps_left;
  std::uint64_t left = steps;
  for (std::size_t i = 0; i < count; ++i) {
    evaluation.steps_left = steps;  // each point may take as many
    for (std::size_t p = 0; p < parameters_; ++p) point[p] = arguments[p][i];
    evaluate(point.data(), values.data(), evaluation);
    for (std::size_t r = 0; r < results_; ++r) results[r][i] = values[r];
    left = std::min(left, evaluation.steps_left);
  }
  evaluation.steps_left = left;
}

}  // namespace firstlight::render
