#include "parser/parse_common.h"
#include "parser/parse_object.h"

#include <string>

namespace firstlight::parser {

using render::Object;

namespace {

Object::Kind combining_kind(Keyword word) {
  switch (word) {
    case Keyword::union_:
      return Object::Kind::union_;
    case Keyword::merge:
      return Object::Kind::merge;
    default:
      return Object::Kind::intersection;
  }
}

}  // namespace

Object parse_csg(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  if (auto declared = accept_declared_object(reader)) {
    parse_modifiers(reader, context, word, *declared);
    return std::move(*declared);
  }
  Object whole;
  whole.kind = combining_kind(word.keyword);
  std::vector<Object> members;
  for (;;) {
    const Token at = reader.peek();
    auto member = parse_object(reader, context);
    if (!member) break;
    if (member->patch && whole.kind == Object::Kind::intersection) {
      reader.warn(at, "a surface without an inside does not work in " + quoted(word));
    }
    // a difference is what is in the first member and outside of all others
    if (word.is(Keyword::difference) && !members.empty()) member->inverted = !member->inverted;
    count_in(reader, at, whole, *member);
    whole.textured = whole.textured || member->textured;
    whole.patch = whole.patch || member->patch;
    members.push_back(std::move(*member));
  }
  if (members.size() < 2) {
    reader.warn(word, quoted(word) + " should have at least two objects, found " + (members.empty() ? "none" : "one"));
  }
  whole.children = std::make_shared<const std::vector<Object>>(std::move(members));
  parse_modifiers(reader, context, word, whole);
  return whole;
}

}  // namespace firstlight::parser
