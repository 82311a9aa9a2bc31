// Shapes that are given by functions.
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::Container;
using render::IsosurfaceForm;
using render::Object;
using render::ParametricForm;
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

bool accept_isosurface_item(Reader& reader, IsosurfaceForm& form) {
  if (reader.accept(Keyword::threshold)) {
    form.threshold = finite_number(reader, "threshold");
  } else if (reader.accept(Keyword::accuracy)) {
    form.accuracy = finite_number(reader, "accuracy");
  } else if (reader.accept(Keyword::max_gradient)) {
    form.max_gradient = finite_number(reader, "max_gradient");
  } else if (reader.accept(Keyword::max_trace)) {
    form.max_trace = integer(reader, "max_trace");
  } else if (reader.accept(Keyword::all_intersections)) {
    form.max_trace = IsosurfaceForm::kMostTraces;
  } else if (reader.accept(Keyword::evaluate)) {
    form.evaluate = parse_evaluate(reader);
  } else if (reader.accept(Keyword::open)) {
    form.open = true;
  } else {
    return accept_container(reader, form.container);
  }
  return true;
}

/// Values that make no sense become the default, with a warning.
void repair(Reader& reader, const Token& word, IsosurfaceForm& form) {
  const auto say = [&](const char* what) { reader.warn(word, std::string(what) + " of 'isosurface' is used"); };
  if (form.accuracy <= 0.0) {
    say("'accuracy' must be above 0; the default");
    form.accuracy = IsosurfaceForm().accuracy;
  }
  if (form.max_gradient <= 0.0) {
    say("'max_gradient' must be above 0; the default");
    form.max_gradient = IsosurfaceForm().max_gradient;
  }
  if (form.max_trace > IsosurfaceForm::kMostTraces) say("'max_trace' is at most 10; the maximum");
  if (form.max_trace < 1) say("'max_trace' must be above 0; the default");
  form.max_trace = std::clamp(form.max_trace, 1, IsosurfaceForm::kMostTraces);
}

/// `precompute depth, x, y, z`, of which letters may be left out.
void parse_precompute(Reader& reader, ParametricForm& form) {
  form.precompute_depth = integer(reader, "precompute", 1, ParametricForm::kDeepestPrecompute);
  static constexpr Keyword kLetters[] = {Keyword::x, Keyword::y, Keyword::z};
  for (std::size_t i = 0; i < 3; ++i) {
    reader.skip_comma();
    form.precompute[i] = reader.accept(kLetters[i]);
  }
}

}  // namespace

void parse_isosurface(Reader& reader, SceneContext&, const Token& word, Object& object) {
  IsosurfaceForm form;
  form.function = parse_surface_function(reader, object);
  while (accept_isosurface_item(reader, form)) {
  }
  repair(reader, word, form);
  set_form(object, std::move(form));
}

void parse_parametric(Reader& reader, SceneContext&, const Token&, Object& object) {
  ParametricForm form;
  for (render::FunctionPtr& function : form.functions) {
    function = parse_surface_function(reader, object);
    reader.skip_comma();
  }
  form.low = finite_vector2(reader, "range of 'parametric'");
  reader.skip_comma();
  form.high = finite_vector2(reader, "range of 'parametric'");
  if (form.low.x > form.high.x) std::swap(form.low.x, form.high.x);
  if (form.low.y > form.high.y) std::swap(form.low.y, form.high.y);
  for (;;) {
    if (reader.accept(Keyword::accuracy)) {
      form.accuracy = finite_number(reader, "accuracy");
    } else if (reader.accept(Keyword::max_gradient)) {
      form.max_gradient = finite_number(reader, "max_gradient");
    } else if (reader.accept(Keyword::precompute)) {
      parse_precompute(reader, form);
    } else if (!accept_container(reader, form.container)) {
      break;
    }
  }
  set_form(object, std::move(form));
}

}  // namespace firstlight::parser
