// Shapes that are given by functions.
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_function.h"
#include "render/shape/isosurface.h"
#include "render/shape/parametric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::Container;
using render::IsosurfaceParameters;
using render::Object;
using render::ParametricParameters;
using render::Vec3;

namespace {

Container parse_box_container(Reader& reader, const Token& word) {
  reader.open_block(word);
  const Vec3 a = finite_vector(reader, "corner in 'contained_by'");
  reader.skip_comma();
  const Vec3 b = finite_vector(reader, "corner in 'contained_by'");
  reader.close_block();
  return render::ContainerBox{Vec3(std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)),
                              Vec3(std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z))};
}

Container parse_sphere_container(Reader& reader, const Token& word) {
  render::ContainerSphere sphere;
  reader.open_block(word);
  sphere.center = finite_vector(reader, "center in 'contained_by'");
  reader.skip_comma();
  sphere.radius = finite_number(reader, "radius in 'contained_by'");
  reader.close_block();
  return sphere;
}

/// `contained_by { box { } }` or `{ sphere { } }`. False: the next word is another.
bool accept_container(Reader& reader, Container& container) {
  const Token& word = reader.peek();
  if (!reader.accept(Keyword::contained_by)) return false;
  reader.open_block(word);
  const Token& kind = reader.peek();
  if (reader.accept(Keyword::box)) {
    container = parse_box_container(reader, kind);
  } else if (reader.accept(Keyword::sphere)) {
    container = parse_sphere_container(reader, kind);
  }
  reader.close_block();
  return true;
}

render::FunctionPtr parse_surface_function(Reader& reader, Object& object) {
  const Token& word = reader.peek();
  if (!reader.accept(Keyword::function)) reader.fail_expected("'function'");
  render::FunctionPtr function = parse_function_block(reader, word);
  object.extras.change().unrendered.add(function->unrendered());
  object.depth = std::max(object.depth, function->depth());
  return function;
}

std::array<double, 3> parse_evaluate(Reader& reader) {
  std::array<double, 3> numbers;
  for (double& number : numbers) {
    number = finite_number(reader, "evaluate");
    if (&number != &numbers.back()) reader.skip_comma();
  }
  return numbers;
}

bool accept_isosurface_item(Reader& reader, IsosurfaceParameters& surface) {
  if (reader.accept(Keyword::threshold)) {
    surface.threshold = finite_number(reader, "threshold");
  } else if (reader.accept(Keyword::accuracy)) {
    surface.accuracy = finite_number(reader, "accuracy");
  } else if (reader.accept(Keyword::max_gradient)) {
    surface.max_gradient = finite_number(reader, "max_gradient");
  } else if (reader.accept(Keyword::max_trace)) {
    surface.max_trace = integer(reader, "max_trace");
  } else if (reader.accept(Keyword::all_intersections)) {
    surface.max_trace = IsosurfaceParameters::kMostTraces;
  } else if (reader.accept(Keyword::evaluate)) {
    surface.evaluate = parse_evaluate(reader);
  } else if (reader.accept(Keyword::open)) {
    surface.open = true;
  } else {
    return accept_container(reader, surface.container);
  }
  return true;
}

/// Values that make no sense become the default, with a warning.
void repair(Reader& reader, const Token& word, IsosurfaceParameters& surface) {
  const auto say = [&](const char* what) { reader.warn(word, std::string(what) + " of 'isosurface' is used"); };
  if (surface.accuracy <= 0.0) {
    say("'accuracy' must be above 0; the default");
    surface.accuracy = IsosurfaceParameters().accuracy;
  }
  if (surface.max_gradient <= 0.0) {
    say("'max_gradient' must be above 0; the default");
    surface.max_gradient = IsosurfaceParameters().max_gradient;
  }
  if (surface.max_trace > IsosurfaceParameters::kMostTraces) say("'max_trace' is at most 10; the maximum");
  if (surface.max_trace < 1) say("'max_trace' must be above 0; the default");
  surface.max_trace = std::clamp(surface.max_trace, 1, IsosurfaceParameters::kMostTraces);
}

/// `precompute depth, x, y, z`, of which letters may be left out.
void parse_precompute(Reader& reader, ParametricParameters& surface) {
  surface.precompute_depth = integer(reader, "precompute", 1, ParametricParameters::kDeepestPrecompute);
  static constexpr Keyword kLetters[] = {Keyword::x, Keyword::y, Keyword::z};
  for (std::size_t i = 0; i < 3; ++i) {
    reader.skip_comma();
    surface.precompute[i] = reader.accept(kLetters[i]);
  }
}

}  // namespace

void parse_isosurface(Reader& reader, SceneContext&, const Token& word, Object& object) {
  IsosurfaceParameters surface;
  surface.function = parse_surface_function(reader, object);
  while (accept_isosurface_item(reader, surface)) {
  }
  repair(reader, word, surface);
  surface.noise_generator = reader.interpreter().language().noise_generator();
  object.shape = render::make_isosurface(surface);
}

void parse_parametric(Reader& reader, SceneContext&, const Token&, Object& object) {
  ParametricParameters surface;
  for (render::FunctionPtr& function : surface.functions) {
    function = parse_surface_function(reader, object);
    reader.skip_comma();
  }
  surface.low = finite_vector2(reader, "range of 'parametric'");
  reader.skip_comma();
  surface.high = finite_vector2(reader, "range of 'parametric'");
  if (surface.low.x > surface.high.x) std::swap(surface.low.x, surface.high.x);
  if (surface.low.y > surface.high.y) std::swap(surface.low.y, surface.high.y);
  for (;;) {
    if (reader.accept(Keyword::accuracy)) {
      surface.accuracy = finite_number(reader, "accuracy");
    } else if (reader.accept(Keyword::max_gradient)) {
      surface.max_gradient = finite_number(reader, "max_gradient");
    } else if (reader.accept(Keyword::precompute)) {
      parse_precompute(reader, surface);
    } else if (!accept_container(reader, surface.container)) {
      break;
    }
  }
  surface.noise_generator = reader.interpreter().language().noise_generator();
  object.patch = true;
  object.shape = render::make_parametric(surface);
}

}  // namespace firstlight::parser
