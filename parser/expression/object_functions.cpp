#include "parser/expression/object_functions.h"

#include "parser/expression/arithmetic.h"
#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"
#include "render/scene/extent.h"

#include <memory>
#include <optional>
#include <string>

namespace firstlight::parser {

using render::Object;
using render::Vec3;

namespace {

using ObjectPtr = std::shared_ptr<const Object>;

void comma(Evaluator& in) {
  if (in.peek().is(Punctuation::comma)) in.take();
}

/// `(object`
ObjectPtr take_object(Evaluator& in, const Token& word) {
  in.expect(Punctuation::left_paren, "after", word.text);
  const Value* value = in.peek_value();
  const auto* held = value != nullptr ? std::get_if<ObjectPtr>(value) : nullptr;
  if (held == nullptr) in.fail(in.peek().location, "expected the name of an object, found " + in.describe_next());
  ObjectPtr object = *held;
  in.take();
  return object;
}

}  // namespace

Numbers parse_trace(Evaluator& in, const Token& word) {
  const ObjectPtr object = take_object(in, word);
  comma(in);
  const Vec3 origin = parse_vector(in);
  comma(in);
  const Vec3 direction = parse_vector(in);
  comma(in);
  const std::optional<render::ObjectProbe::Hit> hit = in.probe(object).trace(origin, direction);
  const Value* normal = in.peek_value();
  if (normal != nullptr && std::holds_alternative<Numbers>(*normal)) {
    const Scopes::Binding variable = in.take_binding();
    *variable.slot = numbers_of(hit ? hit->normal : Vec3(0.0));
  }
  in.expect(Punctuation::right_paren, "to close", word.text);
  return numbers_of(hit ? hit->point : Vec3(0.0));
}

Numbers parse_inside(Evaluator& in, const Token& word) {
  const Token& name = in.peek();
  const ObjectPtr object = take_object(in, word);
  if (object->patch) in.fail(name.location, "'inside' needs an object that has an inside");
  comma(in);
  const Vec3 point = parse_vector(in);
  in.expect(Punctuation::right_paren, "to close", word.text);
  return single(in.probe(object).inside(point) ? 1.0 : 0.0, 1);
}

Numbers parse_extent(Evaluator& in, const Token& word) {
  const ObjectPtr object = take_object(in, word);
  in.expect(Punctuation::right_paren, "to close", word.text);
  const render::Box3 box = render::extent(*object).box();
  return numbers_of(word.is(Keyword::min_extent) ? box.min : box.max);
}

}  // namespace firstlight::parser
