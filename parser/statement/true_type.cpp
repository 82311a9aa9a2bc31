#include "parser/statement/true_type.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>

namespace firstlight::parser {

using render::Vec2;

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 28;
/// Glyphs are made of glyphs, which may be made of glyphs.
constexpr int kDeepest = 8;
constexpr std::size_t kMostParts = 256;
constexpr std::size_t kMostGlyphPoints = std::size_t{1} << 16;

// Flags of points.
constexpr std::uint32_t kOnCurve = 1, kShortX = 2, kShortY = 4, kRepeat = 8, kSameX = 16, kSameY = 32;
// Flags of parts.
constexpr std::uint32_t kWords = 1, kOffsets = 2, kScale = 8, kMore = 32, kTwoScales = 64, kMatrix = 128,
                        kMetrics = 512;

}  // namespace

TrueTypeFont::TrueTypeFont(const std::string& path, bool ascii, std::string& error) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(stream.tellg());
  if (size > 0 && static_cast<std::uint64_t>(size) <= kMostBytes) {
    bytes_.resize(static_cast<std::size_t>(size));
    stream.seekg(0);
    stream.read(bytes_.data(), size);
  }
  const std::size_t head = table("head");
  glyphs_ = table("glyf");
  places_ = table("loca");
  widths_ = table("hmtx");
  kerning_ = table("kern");
  const std::size_t layout = table("hhea");
  const std::size_t most = table("maxp");
  if (head == 0 || glyphs_ == 0 || places_ == 0 || widths_ == 0 || layout == 0 || most == 0 || u16(head + 18) == 0) {
    error = "it is no TrueType font";
    return;
  }
  em_ = u16(head + 18);
  long_places_ = u16(head + 50) != 0;
  glyph_count_ = u16(most + 4);
  width_count_ = u16(layout + 34);
  find_characters(ascii);
  if (characters_ == 0) error = "it has no table of characters that is known";
}

/// Where a table begins; 0: it is not there.
std::size_t TrueTypeFont::table(const char* tag) const {
  const std::uint32_t count = std::min<std::uint32_t>(u16(4), 256);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t at = 12 + 16 * static_cast<std::size_t>(i);
    if (at + 16 <= bytes_.size() && std::memcmp(bytes_.data() + at, tag, 4) == 0) {
      const std::size_t place = u32(at + 8);
      return place < bytes_.size() ? place : 0;
    }
  }
  return 0;
}

/// The platforms are asked one after another: old Macintosh, Windows and Unicode ones. [POV-Ray 3.7]
void TrueTypeFont::find_characters(bool ascii) {
  const std::size_t map = table("cmap");
  if (map == 0) return;
  static constexpr std::array<std::uint32_t, 3> kOfAscii{1, 3, 0};
  static constexpr std::array<std::uint32_t, 3> kOfUnicode{0, 3, 1};
  const std::uint32_t count = u16(map + 2);
  for (const std::uint32_t platform : ascii ? kOfAscii : kOfUnicode) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::size_t entry = map + 4 + 8 * static_cast<std::size_t>(i);
      if (entry + 8 > bytes_.size()) return;
      const std::size_t at = map + u32(entry + 4);
      const std::uint32_t format = u16(at);
      if (u16(entry) == platform && at < bytes_.size() && (format == 0 || format == 4 || format == 6)) {
        characters_ = at;
        return;
      }
    }
  }
}

std::uint32_t TrueTypeFont::glyph_of(std::uint32_t character) const {
  const std::size_t at = characters_;
  switch (u16(at)) {
    case 0:
      return character < 256 ? u8(at + 6 + character) : 0;
    case 6: {
      const std::uint32_t first = u16(at + 6);
      const bool is_there = character >= first && character < first + u16(at + 8);
      return is_there ? u16(at + 10 + 2 * static_cast<std::size_t>(character - first)) : 0;
    }
    default:
      break;
  }
  // Format 4: ranges of characters, each with a step, or with a list of its own.
  const std::size_t twice = u16(at + 6) & ~1u;
  for (std::size_t i = 0; i < twice; i += 2) {
    if (u16(at + 14 + i) < character) continue;
    const std::uint32_t start = u16(at + 16 + twice + i);
    if (start > character) return 0;
    const std::uint32_t step = u16(at + 16 + 2 * twice + i);
    const std::size_t list = at + 16 + 3 * twice + i;
    if (u16(list) == 0) return (character + step) & 0xffffu;
    const std::uint32_t found = u16(list + u16(list) + 2 * static_cast<std::size_t>(character - start));
    return found == 0 ? 0 : (found + step) & 0xffffu;
  }
  return 0;
}

std::size_t TrueTypeFont::glyph_place(std::uint32_t index) const {
  return glyphs_ + (long_places_ ? std::size_t{u32(places_ + 4 * static_cast<std::size_t>(index))}
                                 : 2 * std::size_t{u16(places_ + 2 * static_cast<std::size_t>(index))});
}

TrueTypeFont::Glyph TrueTypeFont::glyph(std::uint32_t index, bool blank) const {
  Glyph glyph;
  glyph.metrics = index;
  return blank ? glyph : outline(index, 0);
}

TrueTypeFont::Glyph TrueTypeFont::outline(std::uint32_t index, int depth) const {
  Glyph glyph;
  glyph.metrics = index;
  if (index >= glyph_count_) return glyph;
  const std::size_t at = glyph_place(index);
  const int contours = s16(at);
  glyph.left = s16(at + 2) / em_;
  if (contours > 0) {
    add_simple(at + 10, contours, glyph);
  } else if (contours < 0 && depth < kDeepest) {
    add_parts(at + 10, glyph, depth);
  }
  return glyph;
}

void TrueTypeFont::add_simple(std::size_t at, int contours, Glyph& glyph) const {
  const std::size_t ends = at;
  at += 2 * static_cast<std::size_t>(contours);
  const std::size_t count = u16(at - 2) + std::size_t{1};
  if (count > kMostGlyphPoints || at >= bytes_.size()) return;
  at += 2 + u16(at);  // past the instructions
  std::vector<std::uint32_t> flags;
  while (flags.size() < count) {
    const std::uint32_t flag = u8(at++);
    const std::size_t times = (flag & kRepeat) != 0 ? 1 + std::size_t{u8(at++)} : 1;
    flags.insert(flags.end(), std::min(times, count - flags.size()), flag);
  }
  std::vector<Point> points(count);
  for (int axis = 0; axis < 2; ++axis) {
    const std::uint32_t is_short = axis == 0 ? kShortX : kShortY;
    const std::uint32_t is_same = axis == 0 ? kSameX : kSameY;
    int place = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if ((flags[i] & is_short) != 0) {
        const int step = static_cast<int>(u8(at++));
        place += (flags[i] & is_same) != 0 ? step : -step;
      } else if ((flags[i] & is_same) == 0) {
        place += s16(at);
        at += 2;
      }
      points[i].at[axis] = place / em_;
      points[i].on_curve = (flags[i] & kOnCurve) != 0;
      if (axis == 0) glyph.left = std::min(glyph.left, place / em_);
    }
  }
  std::size_t first = 0;
  for (int i = 0; i < contours; ++i) {
    const std::size_t end = std::min(count, u16(ends + 2 * static_cast<std::size_t>(i)) + std::size_t{1});
    if (end <= first) continue;
    glyph.contours.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(first),
                                points.begin() + static_cast<std::ptrdiff_t>(end));
    first = end;
  }
}

void TrueTypeFont::add_parts(std::size_t at, Glyph& glyph, int depth) const {
  std::uint32_t flags = kMore;
  for (std::size_t part = 0; (flags & kMore) != 0 && part < kMostParts && at < bytes_.size(); ++part) {
    flags = u16(at);
    const std::uint32_t index = u16(at + 2);
    at += 4;
    // Bytes count without their sign in POV-Ray, but for the fonts that are in use this is the same.
    const bool words = (flags & kWords) != 0;
    const double x = (words ? s16(at) : static_cast<int>(u8(at))) / em_;
    const double y = (words ? s16(at + 2) : static_cast<int>(u8(at + 1))) / em_;
    at += words ? 4 : 2;
    double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
    const auto fraction = [&] {
      at += 2;
      return s16(at - 2) / 16384.0;
    };
    if ((flags & kScale) != 0) {
      xx = yy = fraction();
    } else if ((flags & kTwoScales) != 0) {
      xx = fraction();
      yy = fraction();
    } else if ((flags & kMatrix) != 0) {
      xx = fraction();
      xy = fraction();
      yx = fraction();
      yy = fraction();
    }
    if ((flags & kOffsets) == 0) continue;
    if ((flags & kMetrics) != 0) glyph.metrics = index;
    for (std::vector<Point>& contour : outline(index, depth + 1).contours) {
      for (Point& point : contour) {
        const Vec2 p = point.at;
        point.at = Vec2(xx * p.x + xy * p.y + x, yx * p.x + yy * p.y + y);
      }
      glyph.contours.push_back(std::move(contour));
      if (glyph.contours.size() > kMostGlyphPoints) return;
    }
  }
}

double TrueTypeFont::advance(std::uint32_t index) const {
  if (width_count_ == 0) return 0.0;
  return u16(widths_ + 4 * static_cast<std::size_t>(std::min(index, width_count_ - 1))) / em_;
}

double TrueTypeFont::left_bearing(std::uint32_t index) const {
  if (index < width_count_) return s16(widths_ + 4 * static_cast<std::size_t>(index) + 2) / em_;
  return s16(widths_ + 4 * static_cast<std::size_t>(width_count_) +
             2 * static_cast<std::size_t>(index - width_count_)) /
         em_;
}

double TrueTypeFont::kerning(std::uint32_t left, std::uint32_t right) const {
  if (kerning_ == 0) return 0.0;
  double sum = 0.0;
  const std::uint32_t tables = std::min<std::uint32_t>(u16(kerning_ + 2), 64);
  std::size_t at = kerning_ + 4;
  for (std::uint32_t i = 0; i < tables && at < bytes_.size(); ++i) {
    constexpr std::uint32_t kHorizontal = 1, kNotAStep = 2 | 4;
    const std::uint32_t coverage = u16(at + 4);
    const std::uint32_t pairs = u16(at + 6);
    if ((coverage >> 8) == 0 && (coverage & kHorizontal) != 0 && (coverage & kNotAStep) == 0) {
      for (std::uint32_t k = 0; k < pairs; ++k) {
        const std::size_t pair = at + 14 + 6 * static_cast<std::size_t>(k);
        if (u16(pair) > left || pair >= bytes_.size()) break;
        if (u16(pair) != left || u16(pair + 2) != right) continue;
        sum += s16(pair + 4) / em_;
        break;
      }
    }
    at += std::max<std::size_t>(u16(at + 2), 6);
  }
  return sum;
}

}  // namespace firstlight::parser
