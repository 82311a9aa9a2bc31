// Patterns that the scene describes itself: by a function, by an object, by a file of densities.

#include "render/texture/density_grid.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <cmath>

namespace firstlight::render {
namespace {

class FunctionField final : public Pattern {
 public:
  FunctionField(FunctionPtr function, int noise_generator)
      : function_(std::move(function)), noise_generator_(noise_generator) {}

  /// Only values above 1 are folded back.
  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    double results[Function::kMostResults] = {};
    for (std::size_t i = 0; i < points.size; ++i) {
      Evaluation evaluation;
      evaluation.noise_generator = noise_generator_;
      const double place[3] = {at.of[0][i], at.of[1][i], at.of[2][i]};
      function_->evaluate(place, results, evaluation);
      values[i] = results[0] > 1.0 ? std::fmod(results[0], 1.0) : results[0];
    }
  }

 private:
  FunctionPtr function_;
  int noise_generator_;
};

}  // namespace

PatternPtr pattern::make_function(const PatternRequest& request) {
  return std::make_shared<FunctionField>(request.get<FunctionParameters>().function, request.world.noise_generator);
}

PatternPtr pattern::make_object(const PatternRequest& request) {
  return make_field(
      [inside = request.get<ObjectParameters>().inside](const Vec3& p) { return inside && inside(p) ? 1.0 : 0.0; });
}

PatternPtr pattern::make_density_file(const PatternRequest& request) {
  const auto& parameters = request.get<DensityFileParameters>();
  return make_field([grid = parameters.grid, interpolation = parameters.interpolation](const Vec3& p) {
    return grid ? grid->value(p, interpolation) : 0.0;
  });
}

}  // namespace firstlight::render
