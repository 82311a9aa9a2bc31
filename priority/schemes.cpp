#include "priority/schemes.h"

#include <algorithm>
#include <iterator>

namespace firstlight::priority {
namespace {

constexpr SchemeRow kSchemes[] = {
    {"contribution", "rays that can change the picture most come first", "", "contribution", make_contribution},
    {"level", "rays after fewer reflections and refractions come first", "", "level", make_level},
    {"ray-type", "by kind of ray: primary, reflection, transmission, shadow", "(KIND ...)", "ray-type", make_ray_type},
    {"object", "by the object that a ray left: as named, or as in the scene", "(NAME ...)", "object", make_object},
    {"region", "by rectangles of the picture; without them its middle first", "(X0,Y0,X1,Y1 ...)", "region",
     make_region},
    {"surface", "by the surface that a ray left: clear, mirror, glossy, plain", "(KIND ...)", "surface", make_surface},
    {"complexity", "rays from objects made of fewer parts come first", "", "complexity", make_complexity},
    {"distance", "rays from surfaces nearer to the eye come first", "", "distance", make_distance},
    {"light", "feelers to bright lights come first, or to those named", "(LIGHT ...)", "light", make_light},
    {"light-distance", "feelers to near lights come first", "", "light-distance", make_light_distance},
    {"light-colour", "feelers by their light: white, red, green, blue", "(COLOUR ...)", "light-colour",
     make_light_colour},
    {"sample", "first samples of pixels come before those of anti-aliasing", "", "sample", make_sample},
    {"expr", "by an expression over weight, level, type, x, y and more", "(EXPRESSION)", "expr(weight)",
     make_expression},
    {"recursive", "the traditional order: pixel by pixel, depth first, no queue", "", "recursive", nullptr},
};

}  // namespace

std::span<const SchemeRow> schemes() { return kSchemes; }

const SchemeRow* find_scheme(std::string_view name) {
  const auto* const row = std::ranges::find(kSchemes, name, &SchemeRow::name);
  return row == std::end(kSchemes) ? nullptr : row;
}

std::string scheme_names() {
  std::string names;
  for (const SchemeRow& row : kSchemes) {
    if (!names.empty()) names += ", ";
    names += row.name;
  }
  return names;
}

}  // namespace firstlight::priority
