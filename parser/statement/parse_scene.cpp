#include "parser/directive/declarable.h"
#include "parser/directive/interpreter.h"
#include "parser/statement/parse_atmosphere.h"
#include "parser/statement/parse_camera.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/parse_settings.h"
#include "parser/statement/statements.h"

#include <string>

namespace firstlight::parser {

using render::Object;

namespace {

void parse_scene_camera(Reader& reader, SceneContext& context) {
  const Token& word = reader.take();
  if (language_version(reader) >= 350) {
    if (context.builder.has_camera()) reader.warn(word, "more than one camera in the scene; the last one counts");
    context.camera = context.default_camera;
  }
  context.camera = parse_camera(reader, context, word, context.camera);
  context.builder.set_camera(context.camera);
}

void parse_top_object(Reader& reader, SceneContext& context) {
  const Token& at = reader.peek();
  if (at.is(Punctuation::right_brace)) {
    reader.interpreter().fail_unbalanced(at.location, "expected an object or a directive, found '}'");
  }
  auto object = parse_object(reader, context);
  if (!object) reader.fail_expected("an object or a directive");
  context.size += object->size;
  if (context.size > kMaxObjects) {
    reader.fail_finally(at, "the scene has more than " + std::to_string(kMaxObjects) + " objects");
  }
  // Behind an error only further errors are looked for.
  if (reader.interpreter().recovery().has_failed()) return;
  context.builder.add(*object, context.default_texture);
}

void parse_statement(Reader& reader, SceneContext& context) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return parse_top_object(reader, context);
  switch (next.keyword) {
    case Keyword::camera:
      return parse_scene_camera(reader, context);
    case Keyword::global_settings:
      return parse_global_settings(reader, context, reader.take());
    case Keyword::default_:
      reader.take();
      return parse_default(reader, context);
    case Keyword::max_trace_level: {
      const Token& word = reader.take();
      reader.warn(word, "'max_trace_level' belongs in 'global_settings'");
      return parse_max_trace_level(reader, context, word);
    }
    case Keyword::max_intersections:
      return parse_max_intersections(reader, reader.take());
    case Keyword::declare:
    case Keyword::include:
    case Keyword::version:
      return reader.interpreter().run_bare_directive();
    default:
      if (accept_atmosphere(reader, context)) return;
      return parse_top_object(reader, context);
  }
}

}  // namespace

void parse_scene(Reader& reader, SceneContext& context) {
  Interpreter& interpreter = reader.interpreter();
  for (bool more = true; more;) {
    try {
      interpreter.begin_statement();
      more = !reader.peek().is_end();
      if (more) parse_statement(reader, context);
    } catch (const SyntaxError& error) {
      interpreter.recovery().recover(error);
    }
  }
  if (interpreter.recovery().has_failed()) return;
  const Token& end = reader.peek();
  if (!context.builder.has_camera()) {
    reader.warn(end, "there is no camera in the scene; the default one is taken");
    context.builder.set_camera(context.default_camera);
  }
  if (context.size == 0) reader.warn(end, "there are no objects in the scene");
  if (context.builder.settings().radiosity.enabled) check_radiosity(reader, context);
}

}  // namespace firstlight::parser
