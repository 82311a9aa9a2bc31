#include "parser/directive/interpreter.h"
#include "parser/statement/height_map.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_image.h"
#include "render/shape/mesh.h"

#include <string>
#include <utility>

namespace firstlight::parser {

using render::Object;

namespace {

/// So small that nothing is seen of it; it has no inside.
render::ShapePtr speck() {
  constexpr float kTiny = 1e-30f;
  render::MeshParameters mesh;
  mesh.vertices = {{0.0f, 0.0f, 0.0f}, {kTiny, 0.0f, 0.0f}, {0.0f, kTiny, 0.0f}};
  mesh.faces = {{0, 1, 2}};
  return render::make_mesh(std::move(mesh));
}

}  // namespace

void parse_height_field(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  render::HeightFieldParameters field;
  const render::ImageSource image = parse_image_source(reader, context, false);
  if (image.function) object.extras.change().unrendered.add(image.function->unrendered());
  for (;;) {
    if (reader.accept(Keyword::water_level)) {
      field.water_level = finite_number(reader, "water_level");
      if (language_version(reader) < 200) field.water_level /= 256.0;  // in steps of the picture's brightness
    } else if (reader.accept(Keyword::smooth)) {
      field.smooth = true;
    } else {
      break;
    }
  }
  std::string error;
  read_heights(image, reader.interpreter().language().noise_generator(), field, error);
  if (!error.empty()) reader.fail(word, "the picture of 'height_field' cannot be used: " + error);
  if (field.columns < 2 || field.rows < 2) {
    reader.warn(word, "the picture of 'height_field' has less than two rows or columns, so nothing is seen of it");
    object.shape = speck();
    return;
  }
  object.shape = render::make_height_field(std::move(field));
}

}  // namespace firstlight::parser
