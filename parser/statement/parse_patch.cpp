#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_shape.h"
#include "render/shape/bicubic_patch.h"

namespace firstlight::parser {

using render::ShapePtr;

namespace {

/// Reads what is said about a patch; its type and accuracy change nothing that is seen.
struct Draft : render::BicubicPatchParameters {
  int type = -1;
};

/// The old form: type, flatness of some types, steps, without words.
void parse_wordless(Reader& reader, Draft& draft) {
  const Token& at = reader.peek();
  if (language_version(reader) >= 150) reader.warn(at, "the numbers of 'bicubic_patch' should have their words");
  draft.type = integer(reader, "type");
  draft.flatness = draft.type == 2 || draft.type == 3 ? finite_number(reader, "flatness") : 0.1;
  draft.u_steps = integer(reader, "u_steps");
  draft.v_steps = integer(reader, "v_steps");
}

bool accept_item(Reader& reader, Draft& draft) {
  if (reader.accept(Keyword::type)) {
    draft.type = integer(reader, "type");
  } else if (reader.accept(Keyword::flatness)) {
    draft.flatness = finite_number(reader, "flatness");
  } else if (reader.accept(Keyword::u_steps)) {
    draft.u_steps = integer(reader, "u_steps");
  } else if (reader.accept(Keyword::v_steps)) {
    draft.v_steps = integer(reader, "v_steps");
  } else if (reader.accept(Keyword::accuracy)) {
    finite_number(reader, "accuracy");
  } else {
    return false;
  }
  return true;
}

void parse_corner_uvs(Reader& reader, Draft& draft) {
  for (render::Vec2& uv : draft.uv) {
    uv = finite_vector2(reader, "uv_vectors");
    if (&uv != &draft.uv.back()) reader.skip_comma();
  }
}

}  // namespace

ShapePtr parse_bicubic_patch(Reader& reader, const Token& word) {
  Draft draft;
  while (accept_item(reader, draft)) {
  }
  if (reader.accept(Keyword::uv_vectors)) {
    parse_corner_uvs(reader, draft);
  } else if (reader.at_number()) {
    parse_wordless(reader, draft);
  }
  if (draft.type > 1) {
    reader.warn(word, "'bicubic_patch' has only the types 0 and 1; type 1 is used");
    draft.type = 1;
  }
  if (draft.type < 0) reader.fail(word, "'bicubic_patch' needs its 'type', 0 or 1");
  reader.skip_comma();
  for (auto& row : draft.points) {
    for (render::Vec3& point : row) {
      point = finite_vector(reader, "point of 'bicubic_patch'");
      if (&point != &draft.points.back().back()) reader.skip_comma();
    }
  }
  return render::make_bicubic_patch(draft);
}

}  // namespace firstlight::parser
