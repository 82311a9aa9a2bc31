// `text`: a line of letters, each a shape of its own.
#include "parser/directive/interpreter.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_form.h"
#include "parser/statement/parse_image.h"
#include "parser/statement/parse_object.h"
#include "parser/statement/true_type.h"
#include "render/shape/prism.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace firstlight::parser {

using render::Object;
using render::ProfileSegment;
using render::Vec2;
using render::Vec3;

/// The fonts of a scene, read once, and their letters, whose shapes all texts share.
/// Memory   The last kMostFonts.
class FontStore {
 public:
  struct Letter {
    render::ShapePtr shape;  ///< null: nothing is seen
    double left;             ///< the least x
    std::uint32_t metrics;   ///< of the glyph whose widths it has
  };
  struct Font {
    Font(const std::string& path, bool ascii, std::string& error) : outlines(path, ascii, error) {}

    TrueTypeFont outlines;
    std::map<std::tuple<std::uint32_t, bool, double>, Letter> letters;  ///< by glyph, whether it is blank, thickness

    const Letter& letter(std::uint32_t glyph, bool blank, double thickness);
  };

  /// Null: it cannot be read, and `error` says why. `ascii`: see TrueTypeFont. The font is there until the next call.
  Font* read(const std::string& path, bool ascii, std::string& error) {
    const auto known = fonts_.find({path, ascii});
    if (known != fonts_.end()) return known->second.get();
    auto font = std::make_unique<Font>(path, ascii, error);
    if (!error.empty()) return nullptr;
    if (fonts_.size() == kMostFonts) fonts_.clear();
    return (fonts_[{path, ascii}] = std::move(font)).get();
  }

 private:
  static constexpr std::size_t kMostFonts = 16;

  std::map<std::pair<std::string, bool>, std::unique_ptr<Font>> fonts_;
};

namespace {

/// The files that POV-Ray's built-in fonts are made of: like a logo, Times, Helvetica, Courier.
constexpr std::string_view kBuiltinFonts[] = {"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};

std::uint32_t next_character(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0u; };
  const std::uint32_t first = byte(at++);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
  std::uint32_t character = first & (0x3fu >> more);
  for (int i = 0; i < more && (byte(at) & 0xc0) == 0x80; ++i) character = character << 6 | (byte(at++) & 0x3fu);
  return character;
}

ProfileSegment segment(const Vec2& start, const Vec2& control, const Vec2& end, bool is_line) {
  ProfileSegment part{Vec2(0.0), Vec2(0.0), end - start, start, start, start};
  if (!is_line) {
    part.b = start - control * 2.0 + end;
    part.c = (control - start) * 2.0;
  }
  for (const Vec2& point : {start, is_line ? end : control, end}) {
    for (int axis = 0; axis < 2; ++axis) {
      part.low[axis] = std::min(part.low[axis], point[axis]);
      part.high[axis] = std::max(part.high[axis], point[axis]);
    }
  }
  return part;
}

/// Between two points beside the curve in a row there is one on it, in their middle.
void add_contour(const std::vector<TrueTypeFont::Point>& points, std::vector<ProfileSegment>& outline) {
  const std::size_t count = points.size();
  Vec2 here = points[0].at;
  for (std::size_t i = 1; i <= count; ++i) {
    const TrueTypeFont::Point& point = points[i % count];
    if (point.on_curve) {
      if (point.at != here) outline.push_back(segment(here, here, point.at, true));
      here = point.at;
      continue;
    }
    const TrueTypeFont::Point& next = points[(i + 1) % count];
    Vec2 end = i == count ? points[0].at : next.at;
    if (i < count && !next.on_curve) end = (point.at + next.at) * 0.5;
    outline.push_back(segment(here, point.at, end, false));
    here = end;
  }
}

}  // namespace

const FontStore::Letter& FontStore::Font::letter(std::uint32_t glyph, bool blank, double thickness) {
  constexpr std::size_t kMostLetters = 4096;
  if (letters.size() == kMostLetters) letters.clear();
  const auto [at, is_new] = letters.try_emplace({glyph, blank, thickness});
  if (!is_new) return at->second;
  const TrueTypeFont::Glyph drawn = outlines.glyph(glyph, blank);
  std::vector<ProfileSegment> outline;
  for (const auto& contour : drawn.contours) add_contour(contour, outline);
  at->second = {nullptr, drawn.left, drawn.metrics};
  if (!outline.empty()) at->second.shape = render::make_letter(std::move(outline), thickness);
  return at->second;
}

namespace {

std::string font_file(Reader& reader) {
  if (reader.accept(Keyword::ttf)) return parse_file_name(reader, {".ttf"});
  const Token& word = reader.peek();
  if (!reader.accept(Keyword::internal)) reader.fail_expected("'ttf' or 'internal'");
  const int number = integer(reader, "number of the font");
  const bool is_known = number >= 0 && number < static_cast<int>(std::size(kBuiltinFonts));
  return reader.interpreter().find_file(std::string(kBuiltinFonts[is_known ? number : 0]), {}, word.location);
}

}  // namespace

void parse_text(Reader& reader, SceneContext& context, const Token& word, Object& object) {
  const Token& at = reader.peek();
  const std::string file = font_file(reader);
  std::string error;
  const bool ascii = context.builder.settings().charset == render::Charset::ascii;
  if (!context.fonts) context.fonts = std::make_shared<FontStore>();
  FontStore::Font* const font = context.fonts->read(file, ascii, error);
  if (font == nullptr) reader.fail(at, "the font " + file + " cannot be used: " + error);
  const TrueTypeFont& outlines = font->outlines;
  reader.skip_comma();
  const std::string text = reader.string();
  reader.skip_comma();
  const double thickness = finite_number(reader, "thickness of 'text'");
  reader.skip_comma();
  const Vec3 offset = finite_vector(reader, "offset of 'text'");

  object.kind = Object::Kind::union_;
  std::vector<Object> letters;
  Vec3 place(0.0);
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < text.size();) {
    const bool first = i == 0;
    const std::uint32_t character = next_character(text, i);
    const std::uint32_t index = outlines.glyph_of(character);
    const FontStore::Letter& glyph = font->letter(index, character == ' ', thickness);
    const double kerning = first ? 0.0 : outlines.kerning(last, glyph.metrics);
    const double bearing = outlines.left_bearing(glyph.metrics);
    const double left = first ? -glyph.left : place.x + bearing - glyph.left + kerning;
    if (glyph.shape != nullptr) {
      Object& letter = letters.emplace_back();
      letter.word = object.word;
      letter.shape = glyph.shape;
      render::place(letter, render::Transform::translation(Vec3(left, place.y, place.z)));
      count_in(reader, word, object, letter);
    }
    const double advance = outlines.advance(glyph.metrics);
    place.x = first ? advance - bearing : place.x + advance + kerning;
    place += offset;
    last = index;
  }
  object.children = render::make_object_list(std::move(letters));
  // POV-Ray turns every text a little, so that its letters do not lie exactly in the planes of other objects.
  render::place(object, render::Transform::rotation(Vec3(0.001)));
}

}  // namespace firstlight::parser
