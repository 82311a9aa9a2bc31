#pragma once

#include "render/feature/feature.h"
#include "render/scene/forms/analytic.h"
#include "render/scene/forms/field.h"
#include "render/scene/forms/sphere_sweep.h"

#include <variant>

namespace firstlight::render {

/// A shape as it is described. Immutable once it is part of an Object, and shared by its copies.
struct Form {
  std::variant<IsosurfaceForm, JuliaFractalForm, ParametricForm, SphereSweepForm> shape;
};

/// What must be rendered to show it.
Feature feature_of(const Form& form);
/// Whether it is a surface without an inside.
bool is_patch(const Form& form);

}  // namespace firstlight::render
