#include "parser/parse_common.h"
#include "parser/parse_form.h"
#include "parser/parse_image.h"

#include <utility>

namespace firstlight::parser {

using render::Object;

void parse_height_field(Reader& reader, SceneContext& context, const Token&, Object& object) {
  render::HeightFieldForm form;
  form.image = parse_image_source(reader, context, false);
  if (form.image.function) object.extras.change().unrendered.add(form.image.function->unrendered());
  for (;;) {
    if (reader.accept(Keyword::water_level)) {
      form.water_level = finite_number(reader, "water_level");
      if (language_version(reader) < 200) form.water_level /= 256.0;  // in steps of the picture's brightness
    } else if (reader.accept(Keyword::smooth)) {
      form.smooth = true;
    } else {
      break;
    }
  }
  set_form(object, std::move(form));
}

}  // namespace firstlight::parser
