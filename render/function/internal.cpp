#include "render/function/internal.h"

#include <algorithm>
#include <array>
#include <memory>

namespace firstlight::render {
namespace {

class Internal final : public Function {
 public:
  explicit Internal(const InternalFunction& row) : Function(row.parameters, 1, 20), formula_(row.formula) {}
  void evaluate(const double* arguments, double* results, Evaluation& evaluation) const override {
    *results = formula_(arguments, evaluation);
  }
  void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                     Evaluation& evaluation) const override {
    std::array<double, kMostParameters> point;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t p = 0; p < parameter_count(); ++p) point[p] = arguments[p][i];
      results[0][i] = formula_(point.data(), evaluation);
    }
  }

 private:
  InternalFunction::Formula formula_;
};

}  // namespace

FunctionPtr make_internal(std::size_t number) {
  for (const auto rows : {internal_noise(), internal_plane(), internal_solids(), internal_surfaces()}) {
    const auto found = std::ranges::find(rows, number, &InternalFunction::number);
    if (found != rows.end()) return std::make_shared<Internal>(*found);
  }
  return nullptr;
}

}  // namespace firstlight::render
