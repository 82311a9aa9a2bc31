// Patterns that the scene describes itself: by a function, by an object, by a file of densities.

#include "render/texture/density_grid.h"
#include "render/texture/field.h"
#include "render/texture/patterns.h"

#include <array>
#include <cmath>

namespace firstlight::render {
namespace {

class FunctionField final : public Pattern {
 public:
  FunctionField(FunctionPtr function, int noise_generator)
      : function_(std::move(function)), noise_generator_(noise_generator) {}

  /// Only values above 1 are folded back.
  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    std::array<Column<double>, Function::kMostResults - 1> others;
    std::array<double*, Function::kMostResults> results{values.at.data()};
    for (std::size_t r = 1; r < results.size(); ++r) results[r] = others[r - 1].at.data();
    const std::array<const double*, 3> places{at.of[0].at.data(), at.of[1].at.data(), at.of[2].at.data()};
    Evaluation evaluation{.noise_generator = noise_generator_};
    function_->evaluate_many(places.data(), results.data(), points.size, evaluation);
    for (std::size_t i = 0; i < points.size; ++i) {
      if (values[i] > 1.0) values[i] = std::fmod(values[i], 1.0);
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
