#include "render/scene/form.h"

namespace firstlight::render {
namespace {

// Overloads rather than a table by index: the variant may get a new alternative anywhere.
Feature feature(const BicubicPatchForm&) { return Feature::bicubic_patch; }
Feature feature(const BlobForm&) { return Feature::blob; }
Feature feature(const HeightFieldForm&) { return Feature::height_field; }
Feature feature(const IsosurfaceForm&) { return Feature::isosurface; }
Feature feature(const JuliaFractalForm&) { return Feature::julia_fractal; }
Feature feature(const LatheForm&) { return Feature::lathe; }
Feature feature(const MeshForm&) { return Feature::mesh; }
Feature feature(const OvusForm&) { return Feature::ovus; }
Feature feature(const ParametricForm&) { return Feature::parametric; }
Feature feature(const PolygonForm&) { return Feature::polygon; }
Feature feature(const PolynomialForm&) { return Feature::poly; }
Feature feature(const PrismForm&) { return Feature::prism; }
Feature feature(const QuadricForm&) { return Feature::quadric; }
Feature feature(const SphereSweepForm&) { return Feature::sphere_sweep; }
Feature feature(const SuperellipsoidForm&) { return Feature::superellipsoid; }
Feature feature(const SurfaceOfRevolutionForm&) { return Feature::sor; }
Feature feature(const TextForm&) { return Feature::text; }

}  // namespace

Feature feature_of(const Form& form) {
  return std::visit([](const auto& shape) { return feature(shape); }, form.shape);
}

bool is_patch(const Form& form) {
  if (const auto* mesh = std::get_if<MeshForm>(&form.shape)) return !mesh->inside_vector;
  return std::holds_alternative<BicubicPatchForm>(form.shape) || std::holds_alternative<ParametricForm>(form.shape);
}

std::vector<TexturePtr> textures_of(const Form& form) {
  if (const auto* mesh = std::get_if<MeshForm>(&form.shape)) return mesh->textures;
  std::vector<TexturePtr> textures;
  if (const auto* blob = std::get_if<BlobForm>(&form.shape)) {
    for (const BlobForm::Component& component : blob->components) {
      if (component.texture) textures.push_back(component.texture);
    }
  }
  return textures;
}

}  // namespace firstlight::render
