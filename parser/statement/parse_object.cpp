#include "parser/statement/parse_object.h"

#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_shape.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

using render::Object;

namespace {

/// How the word of a shape is read: one of `read` and `read_rich` is there.
struct ShapeWord {
  ShapeReader read = nullptr;
  RichReader read_rich = nullptr;
  bool patch = false;
};

ShapeWord shape_word(Keyword word) {
  switch (word) {
#define SHAPE(word, function) \
  case Keyword::word:         \
    return {.read = function};
#define PATCH(word, function) \
  case Keyword::word:         \
    return {.read = function, .patch = true};
#define RICH(word, function) \
  case Keyword::word:        \
    return {.read_rich = function};
#include "parser/shapes.def"
#undef RICH
#undef PATCH
#undef SHAPE
    default:
      return {};
  }
}

std::optional<Object> parse_shape(Reader& reader, SceneContext& context, const ShapeWord& shape) {
  const Token& word = reader.take();
  reader.open_block(word);
  std::optional<Object> result = accept_declared_object(reader);
  if (result) {
    parse_modifiers(reader, context, word, *result);
    return result;
  }
  Object& object = result.emplace();  // most objects are made here, and moved nowhere
  object.word = spelling(word.keyword);
  if (shape.read) {
    object.shape = shape.read(reader, word);
  } else {
    shape.read_rich(reader, context, word, object);
  }
  if (object.shape) {
    object.patch = object.patch || shape.patch;
    for (const auto& texture : object.extras->shape_textures) object.depth = std::max(object.depth, depth_of(*texture));
    object.cramped = object.shape->given_bounds() != object.shape->bounds();
  } else if (!object.children) {
    object = empty_object();
  }
  parse_modifiers(reader, context, word, object);
  return result;
}

void add_name(Object& object, std::string_view name) {
  // A loop that declares an object of itself again and again gives it the same name again and again.
  if (!object.extras->names.empty() && object.extras->names.front() == name) return;
  auto& names = object.extras.change().names;
  if (names.size() == render::ObjectExtras::kMostNames) names.pop_back();
  names.emplace(names.begin(), name);
}

/// `object { any object, modifiers }`
Object parse_wrapped(Reader& reader, SceneContext& context) {
  const Token& word = reader.take();
  reader.open_block(word);
  auto object = parse_object(reader, context);
  if (!object) reader.fail_expected("an object");
  parse_modifiers(reader, context, word, *object);
  return std::move(*object);
}

}  // namespace

std::optional<Object> accept_declared_object(Reader& reader) {
  const Token& name = reader.peek();
  const auto declared = reader.accept_declared<Object>();
  if (!declared) return std::nullopt;
  Object object = *declared;
  add_name(object, name.text);
  return object;
}

std::optional<Object> parse_object(Reader& reader, SceneContext& context) {
  const Token& next = reader.peek();
  if (next.kind == TokenKind::identifier) return accept_declared_object(reader);
  if (next.kind != TokenKind::keyword) return std::nullopt;
  const ShapeWord shape = shape_word(next.keyword);
  if (shape.read || shape.read_rich) return parse_shape(reader, context, shape);
  switch (next.keyword) {
    case Keyword::object:
      return parse_wrapped(reader, context);
    case Keyword::composite:
    case Keyword::union_:
    case Keyword::merge:
    case Keyword::intersection:
    case Keyword::difference: {
      const Token& word = reader.take();
      return parse_csg(reader, context, word);
    }
    case Keyword::light_group: {
      const Token& word = reader.take();
      return parse_light_group(reader, context, word);
    }
    case Keyword::light_source: {
      const Token& word = reader.take();
      return parse_light(reader, context, word);
    }
    default:
      return std::nullopt;
  }
}

void count_in(Reader& reader, const Token& at, Object& whole, const Object& part) {
  const bool dissolves = whole.kind == Object::Kind::union_ && render::is_plain_union(part);
  whole.depth = std::max(whole.depth, part.depth + (dissolves ? 0 : 1));
  whole.nesting = std::max(whole.nesting, part.nesting + 1);
  whole.size += part.size;
  if (whole.depth > render::kMostDepth) {
    reader.fail_finally(at, "objects are nested more than " + std::to_string(render::kMostDepth) + " deep");
  }
  if (whole.size > kMaxObjects) {
    reader.fail_finally(at, "object is made of more than " + std::to_string(kMaxObjects) + " others");
  }
}

Object empty_object() {
  Object object;
  object.kind = Object::Kind::union_;
  object.children = render::make_object_list({});
  return object;
}

}  // namespace firstlight::parser
