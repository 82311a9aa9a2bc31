#include "parser/parse_common.h"
#include "parser/parse_form.h"

namespace firstlight::parser {

using render::BicubicPatchForm;
using render::Object;

namespace {

/// The old form: type, flatness of some types, steps, without words.
void parse_wordless(Reader& reader, BicubicPatchForm& form) {
  const Token& at = reader.peek();
  if (language_version(reader) >= 150) reader.warn(at, "the numbers of 'bicubic_patch' should have their words");
  form.type = integer(reader, "type");
  form.flatness = form.type == 2 || form.type == 3 ? finite_number(reader, "flatness") : 0.1;
  form.u_steps = integer(reader, "u_steps");
  form.v_steps = integer(reader, "v_steps");
}

bool accept_item(Reader& reader, BicubicPatchForm& form) {
  if (reader.accept(Keyword::type)) {
    form.type = integer(reader, "type");
  } else if (reader.accept(Keyword::flatness)) {
    form.flatness = finite_number(reader, "flatness");
  } else if (reader.accept(Keyword::u_steps)) {
    form.u_steps = integer(reader, "u_steps");
  } else if (reader.accept(Keyword::v_steps)) {
    form.v_steps = integer(reader, "v_steps");
  } else if (reader.accept(Keyword::accuracy)) {
    form.accuracy = finite_number(reader, "accuracy");
  } else {
    return false;
  }
  return true;
}

void parse_corner_uvs(Reader& reader, BicubicPatchForm& form) {
  for (render::Vec2& uv : form.uv) {
    uv = finite_vector2(reader, "uv_vectors");
    if (&uv != &form.uv.back()) reader.skip_comma();
  }
}

}  // namespace

void parse_bicubic_patch(Reader& reader, SceneContext&, const Token& word, Object& object) {
  BicubicPatchForm form;
  form.type = -1;
  while (accept_item(reader, form)) {
  }
  if (reader.accept(Keyword::uv_vectors)) {
    parse_corner_uvs(reader, form);
  } else if (reader.at_number()) {
    parse_wordless(reader, form);
  }
  if (form.type > 1) {
    reader.warn(word, "'bicubic_patch' has only the types 0 and 1; type 1 is used");
    form.type = 1;
  }
  if (form.type < 0) reader.fail(word, "'bicubic_patch' needs its 'type', 0 or 1");
  reader.skip_comma();
  for (auto& row : form.points) {
    for (render::Vec3& point : row) {
      point = finite_vector(reader, "point of 'bicubic_patch'");
      if (&point != &form.points.back().back()) reader.skip_comma();
    }
  }
  set_form(object, form);
}

}  // namespace firstlight::parser
