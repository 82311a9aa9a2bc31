#include "parser/statement/parse_photons.h"

#include "parser/statement/parse_common.h"

#include <algorithm>
#include <string>

namespace firstlight::parser {

using render::PhotonRole;

namespace {

/// `reflection` and `refraction` with their number. False: the next word is neither.
bool accept_way(Reader& reader, std::optional<bool>& reflection, std::optional<bool>& refraction) {
  if (reader.accept(Keyword::reflection)) {
    reflection = integer(reader, "reflection") != 0;
  } else if (reader.accept(Keyword::refraction)) {
    refraction = integer(reader, "refraction") != 0;
  } else {
    return false;
  }
  return true;
}

/// Photons are either shot at an object and bent by it, or pass it by; `word` is what was said last.
void settle(Reader& reader, const Token& word, PhotonRole& role) {
  if (!role.pass_through || role.target <= 0.0 || !role.refraction.value_or(true)) return;
  const bool pass_by_gives_way = !word.is(Keyword::pass_through) && role.refraction.has_value();
  reader.warn(word, std::string("'pass_through' does not go with 'target' and 'refraction'; ") +
                        (pass_by_gives_way ? "'pass_through' is turned off" : "'refraction' is turned off"));
  if (pass_by_gives_way) {
    role.pass_through = false;
  } else {
    role.refraction = false;
  }
}

}  // namespace

void parse_object_photons(Reader& reader, const Token& word, PhotonRole& role) {
  reader.open_block(word);
  for (;;) {
    const Token& item = reader.peek();
    if (reader.accept(Keyword::target)) {
      role.target = std::max(0.0, reader.optional_number(1.0));
    } else if (reader.accept(Keyword::pass_through)) {
      role.pass_through = static_cast<int>(reader.optional_number(1.0)) != 0;
    } else if (reader.accept(Keyword::collect)) {
      role.collect = reader.optional_number(1.0) > 0.0;
    } else if (!accept_way(reader, role.reflection, role.refraction)) {
      break;
    }
    settle(reader, item, role);
  }
  reader.close_block();
}

void parse_light_photons(Reader& reader, const Token& word, render::Light& light) {
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::area_light)) {
      light.photon_area_light = true;
    } else if (!accept_way(reader, light.photon_reflection, light.photon_refraction)) {
      break;
    }
  }
  reader.close_block();
}

}  // namespace firstlight::parser
