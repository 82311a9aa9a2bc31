#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_photons.h"
#include "parser/statement/parse_transform.h"

#include <string>

namespace firstlight::parser {

using render::Object;

namespace {

Object::Kind combining_kind(Keyword word) {
  switch (word) {
    case Keyword::composite:
    case Keyword::union_:
      return Object::Kind::union_;
    case Keyword::merge:
      return Object::Kind::merge;
    default:
      return Object::Kind::intersection;
  }
}

/// Enters what `whole` takes over from a member.
void add_member(Reader& reader, const Token& at, Object& whole, const Object& member) {
  count_in(reader, at, whole, member);
  whole.textured = whole.textured || member.textured;
  whole.patch = whole.patch || member.patch;
  whole.cuts_away = whole.cuts_away || member.cuts_away;
  // a disc is the half space behind it, and far beyond its box
  whole.cramped = whole.cramped || member.cramped || member.word == spelling(Keyword::disc);
}

}  // namespace

Object parse_csg(Reader& reader, SceneContext& context, const Token& word) {
  if (word.is(Keyword::composite)) reader.warn(word, "'composite' is an old word for 'union'");
  reader.open_block(word);
  if (auto declared = accept_declared_object(reader)) {
    parse_modifiers(reader, context, word, *declared);
    return std::move(*declared);
  }
  Object whole;
  whole.kind = combining_kind(word.keyword);
  whole.difference = word.is(Keyword::difference);
  std::vector<Object> members;
  for (;;) {
    const Token& at = reader.peek();
    auto member = parse_object(reader, context);
    if (!member) break;
    if (member->patch && whole.kind == Object::Kind::intersection) {
      reader.warn(at, "a surface without an inside does not work in " + quoted(word));
    }
    // a difference is what is in the first member and outside of all others
    if (word.is(Keyword::difference) && !members.empty()) invert(*member);
    add_member(reader, at, whole, *member);
    members.push_back(std::move(*member));
  }
  if (members.size() < 2) {
    reader.warn(word, quoted(word) + " should have at least two objects, found " + (members.empty() ? "none" : "one"));
  }
  whole.children = render::make_object_list(std::move(members));
  parse_modifiers(reader, context, word, whole);
  return whole;
}

Object parse_light_group(Reader& reader, SceneContext& context, const Token& word) {
  reader.open_block(word);
  Object group;
  group.kind = Object::Kind::union_;
  render::ObjectExtras& extras = group.extras.change();
  extras.light_group = true;
  extras.unrendered.add(feature_use(render::Feature::light_group, word));
  std::vector<Object> members;
  for (;;) {
    const Token& at = reader.peek();
    auto member = parse_object(reader, context);
    if (!member) break;
    add_member(reader, at, group, *member);
    members.push_back(std::move(*member));
  }
  group.children = render::make_object_list(std::move(members));
  for (;;) {
    const Token& next = reader.peek();
    if (const auto transform = accept_transformation(reader)) {
      render::place(group, *transform);
    } else if (reader.accept(Keyword::global_lights)) {
      extras.global_lights = reader.optional_number(1.0) > 0.5;
    } else if (reader.accept(Keyword::photons)) {
      parse_object_photons(reader, next, extras.photons);
    } else {
      break;
    }
  }
  reader.close_block();
  return group;
}

}  // namespace firstlight::parser
