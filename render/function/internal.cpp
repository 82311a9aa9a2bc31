#include "render/function/internal.h"

#include <algorithm>
#include <memory>

namespace firstlight::render {
namespace {

class Internal final : public Function {
 public:
  Internal(const InternalFunction& function, const InternalFamily& family)
      : Function(function.parameters, 1, 20), function_(function), many_(family.many) {}
  void evaluate(const double* arguments, double* results, Evaluation& evaluation) const override {
    *results = function_.formula(arguments, evaluation.noise_generator);
  }
  void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                     Evaluation& evaluation) const override {
    many_(function_.number, arguments, results[0], count, evaluation.noise_generator);
  }

 private:
  InternalFunction function_;
  decltype(InternalFamily::many) many_;
};

}  // namespace

FunctionPtr make_internal(std::size_t number) {
  for (const InternalFamily& family : {internal_noise(), internal_plane(), internal_solids(), internal_surfaces()}) {
    const auto found = std::ranges::find(family.functions, number, &InternalFunction::number);
    if (found != family.functions.end()) return std::make_shared<Internal>(*found, family);
  }
  return nullptr;
}

}  // namespace firstlight::render
