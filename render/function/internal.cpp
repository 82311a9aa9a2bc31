#include "render/function/internal.h"

#include <algorithm>
#include <memory>

namespace firstlight::render {
namespace {

class Internal final : public Function {
 public:
  explicit Internal(const InternalFunction& row) : Function(row.parameters, 1, 20), formula_(row.formula) {}
  void evaluate(const double* arguments, double* results, Evaluation& evaluation) const override {
    *results = formula_(arguments, evaluation);
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
