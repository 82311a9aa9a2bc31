#include "render/scene/form.h"

namespace firstlight::render {
namespace {

// Overloads rather than a table by index: the variant may get a new alternative anywhere.
Feature feature(const IsosurfaceForm&) { return Feature::isosurface; }
Feature feature(const JuliaFractalForm&) { return Feature::julia_fractal; }
Feature feature(const ParametricForm&) { return Feature::parametric; }
Feature feature(const SphereSweepForm&) { return Feature::sphere_sweep; }

}  // namespace

Feature feature_of(const Form& form) {
  return std::visit([](const auto& shape) { return feature(shape); }, form.shape);
}

bool is_patch(const Form& form) {
  return std::holds_alternative<ParametricForm>(form.shape);
}

}  // namespace firstlight::render
