// #version, and the defaults that go with a version.
#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/expression/expression.h"

#include <utility>

namespace firstlight::parser {

void Interpreter::run_version(const Token& word, bool first) {
  Reader reader(*this);
  const Hold hold(*this);
  if (peek().kind == TokenKind::identifier && peek().text == "unofficial") take_binding();
  const Token& at = peek();
  const double version = reader.number();
  if (!(version >= 1.0 && version * 100.0 + 0.5 < LanguageState::kNewest + 1)) {
    fail(at.location, "expected a version of the language from 1.0 to 3.8, found " + describe(at));
  }
  const int before = language().version();
  language().set_version(static_cast<int>(version * 100.0 + 0.5), first);
  if ((before >= 380) != (language().version() >= 380)) change_defaults(word);
  if (peek().is(Punctuation::semicolon)) {
    take();
  } else if (language().version() >= 310) {
    warn(word.location, "expected ';' at the end of '#version', found " + describe_next());
  }
}

// Changes the defaults that differ from 3.8 on, unless the scene has set some by then: the pigment is white, not black,
// nothing glows, and the camera's picture has square pixels. [POV-Ray 3.8, changes.txt]
void Interpreter::change_defaults(const Token& word) {
  if (context_.default_given) {
    return warn(word.location, "there was a '#default' before, so the defaults do not follow the version");
  }
  const bool newer = language().version() >= 380;
  auto texture = std::make_shared<render::Texture>(*context_.default_texture);
  const float white = newer ? 1.0f : 0.0f, ambient = newer ? 0.0f : 0.1f;
  texture->layers[0].pigment.color.rgb = render::Rgb(white, white, white);
  texture->layers[0].finish.change().ambient = render::Rgb(ambient, ambient, ambient);
  context_.default_texture = std::move(texture);
  const double aspect = static_cast<double>(options().width) / options().height;
  context_.default_camera.right = {newer ? aspect : render::Camera().right.x, 0.0, 0.0};
  context_.camera.right = context_.default_camera.right;
}

}  // namespace firstlight::parser
