#pragma once

#include "render/feature/feature.h"
#include "render/scene/forms/analytic.h"
#include "render/scene/forms/blob.h"
#include "render/scene/forms/field.h"
#include "render/scene/forms/height_field.h"
#include "render/scene/forms/mesh.h"
#include "render/scene/forms/patch.h"
#include "render/scene/forms/profile.h"
#include "render/scene/forms/text.h"
#include "render/texture/texture.h"

#include <variant>
#include <vector>

namespace firstlight::render {

/// A shape as it is described. Immutable once it is part of an Object, and shared by its copies.
struct Form {
  std::variant<BicubicPatchForm, BlobForm, HeightFieldForm, IsosurfaceForm, JuliaFractalForm, LatheForm, MeshForm,
               OvusForm, ParametricForm, PolygonForm, PolynomialForm, PrismForm, QuadricForm, SphereSweepForm,
               SuperellipsoidForm, SurfaceOfRevolutionForm, TextForm>
      shape;
};

/// What must be rendered to show it.
Feature feature_of(const Form& form);
/// Whether it is a surface without an inside.
bool is_patch(const Form& form);
/// The textures of its parts, each once or more.
std::vector<TexturePtr> textures_of(const Form& form);

}  // namespace firstlight::render
