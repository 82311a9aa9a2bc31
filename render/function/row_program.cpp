#include "render/function/row_program.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/function/row_program.cpp"
#include <hwy/foreach_target.h>

#include "render/function/operations-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Points from one call, at most RowProgram::kPoints, whose rows have room for a multiple of eight.
void run_steps(const RowProgram& program, const double* const* arguments, double* result, std::size_t count,
               Evaluation& evaluation) {
  std::array<RowProgram::Row, RowProgram::kMostRows> own;
  const double* row[Function::kMostParameters + RowProgram::kMostConstants + RowProgram::kMostRows];
  const std::size_t parameters = program.parameters();
  const std::size_t given = parameters + program.constants().size();
  for (std::size_t i = 0; i < parameters; ++i) row[i] = arguments[i];
  for (std::size_t i = parameters; i < given; ++i) row[i] = program.constants()[i - parameters].at.data();
  for (std::size_t i = 0; i < program.rows(); ++i) row[given + i] = own[i].at.data();
  for (const RowProgram::Step& step : program.steps()) {
    if (step.callee == nullptr) {
      const double* const from[4] = {row[step.from[0]], row[step.from[1]], row[step.from[2]], row[step.from[3]]};
      operate<Lanes>(step.instruction, from, own[step.to[0] - given].at.data(), count);
      continue;
    }
    const double* rows[Function::kMostParameters];
    double* results[Function::kMostResults];
    const std::uint32_t* numbers = program.call_rows().data() + step.from[0];
    for (std::size_t p = 0; p < step.callee->parameter_count(); ++p) rows[p] = row[numbers[p]];
    for (std::size_t r = 0; r < step.callee->result_count(); ++r) results[r] = own[step.to[r] - given].at.data();
    step.callee->evaluate_many(rows, results, count, evaluation);
  }
  std::copy_n(row[program.result()], count, result);
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(run_steps);

void RowProgram::evaluate(const double* const* arguments, double* results, std::size_t count,
                          Evaluation& evaluation) const {
  constexpr std::size_t kWidest = 8;
  std::array<const double*, Function::kMostParameters> rows;
  for (std::size_t begin = 0; begin < count; begin += kPoints) {
    const std::size_t points = std::min(kPoints, count - begin);
    if (points % kWidest == 0) {
      for (std::size_t p = 0; p < parameters_; ++p) rows[p] = arguments[p] == nullptr ? nullptr : arguments[p] + begin;
      HWY_DYNAMIC_DISPATCH(run_steps)(*this, rows.data(), results + begin, points, evaluation);
      continue;
    }
    std::array<Row, Function::kMostParameters> copies;
    rows.fill(nullptr);
    for (std::size_t p = 0; p < parameters_; ++p) {
      if (arguments[p] == nullptr) continue;
      std::copy_n(arguments[p] + begin, points, copies[p].at.begin());
      rows[p] = copies[p].at.data();
    }
    HWY_DYNAMIC_DISPATCH(run_steps)(*this, rows.data(), results + begin, points, evaluation);
  }
}

}  // namespace firstlight::render
#endif
