#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_transform.h"

#include <string>

namespace firstlight::parser {

using render::Object;
using Members = std::vector<Object>;

namespace {

/// Objects and the transformations of all of them, up to the `}`.
Members parse_members(Reader& reader, SceneContext& context, const Token& word) {
  Members members;
  for (;;) {
    const Token& at = reader.peek();
    auto member = parse_object(reader, context);
    if (!member) break;
    if (member->textured) reader.fail(at, "an object in " + quoted(word) + " cannot have a texture");
    if (member->patch) {
      reader.fail(at, "an object in " + quoted(word) + " must have an inside");
    }
    members.push_back(std::move(*member));
  }
  while (const auto transform = accept_transformation(reader)) {
    for (Object& member : members) render::place(member, *transform);
  }
  if (members.empty()) reader.fail_expected("an object");
  return members;
}

/// Adds `members`, given in the space around `object`, to one of its lists, which are kept in its own space.
void append(Reader& reader, const Token& word, Object& object, render::ObjectList& list, Members members) {
  const render::Transform to_object = object.placement.inverse();
  auto grown = list ? std::make_shared<Members>(*list) : std::make_shared<Members>();
  for (Object& member : members) {
    if (!to_object.is_identity()) render::place(member, to_object);
    count_in(reader, word, object, member);
    grown->push_back(std::move(member));
  }
  list = std::move(grown);
  object.cramped = true;
}

}  // namespace

void parse_bounded_by(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  reader.open_block(word);
  render::ObjectExtras& extras = object.extras.change();
  if (extras.bounds_are_clips)
    reader.fail(word, "bounds cannot be added after 'bounded_by' and 'clipped_by' were made one");
  if (reader.next_is(Keyword::clipped_by)) {
    const Token& at = reader.take();
    if (extras.bounded_by) reader.fail(at, "'clipped_by' cannot replace bounds that are there already");
    extras.bounded_by = extras.clipped_by;
    extras.bounds_are_clips = extras.clipped_by != nullptr;
  } else {
    append(reader, word, object, extras.bounded_by, parse_members(reader, context, word));
  }
  reader.close_block();
}

void parse_clipped_by(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  reader.open_block(word);
  render::ObjectExtras& extras = object.extras.change();
  if (extras.bounds_are_clips)
    reader.fail(word, "clips cannot be added after 'bounded_by' and 'clipped_by' were made one");
  if (reader.next_is(Keyword::bounded_by)) {
    const Token& at = reader.take();
    if (extras.clipped_by) reader.fail(at, "'bounded_by' cannot replace clips that are there already");
    extras.clipped_by = extras.bounded_by;
    extras.bounds_are_clips = extras.bounded_by != nullptr;
  } else {
    append(reader, word, object, extras.clipped_by, parse_members(reader, context, word));
  }
  reader.close_block();
}

}  // namespace firstlight::parser
