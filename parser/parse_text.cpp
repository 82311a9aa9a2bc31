#include "parser/parse_common.h"
#include "parser/parse_form.h"
#include "parser/parse_image.h"

namespace firstlight::parser {

using render::Object;

namespace {

constexpr int kBuiltinFonts = 4;

}  // namespace

void parse_text(Reader& reader, SceneContext&, const Token&, Object& object) {
  render::TextForm form;
  if (reader.accept(Keyword::ttf)) {
    form.font_file = parse_file_name(reader, {".ttf"});
  } else if (reader.accept(Keyword::internal)) {
    form.builtin_font = integer(reader, "number of the font");
    if (form.builtin_font < 0 || form.builtin_font >= kBuiltinFonts) form.builtin_font = 0;
  } else {
    reader.fail_expected("'ttf' or 'internal'");
  }
  reader.skip_comma();
  form.text = reader.string();
  reader.skip_comma();
  form.thickness = finite_number(reader, "thickness of 'text'");
  reader.skip_comma();
  form.offset = finite_vector(reader, "offset of 'text'");
  set_form(object, std::move(form));
  // POV-Ray turns every text a little, so that its letters do not lie exactly in the planes of other objects.
  render::place(object, render::Transform::rotation(render::Vec3(0.001)));
}

}  // namespace firstlight::parser
