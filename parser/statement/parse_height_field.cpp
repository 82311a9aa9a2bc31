#include "parser/directive/interpreter.h"
#include "parser/statement/height_map.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_image.h"

#include <string>
#include <utility>

namespace firstlight::parser {

using render::Object;

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
  object.shape = render::make_height_field(std::move(field));
}

}  // namespace firstlight::parser
