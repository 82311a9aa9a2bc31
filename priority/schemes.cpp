#include "priority/schemes.h"

#include <algorithm>
#include <iterator>

namespace firstlight::priority {
namespace {

constexpr SchemeRow kSchemes[] = {
    {"contribution", "rays that can change the picture most come first", "", "contribution", make_contribution},
    {"level", "rays after fewer reflections and refractions come first", "", "level", make_level},
    {"ray-type", "by kind of ray; without a list: primary, reflection, transmission, shadow", "(KIND ...)", "ray-type",
     make_ray_type},
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
