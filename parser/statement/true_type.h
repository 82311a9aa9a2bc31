#pragma once

#include "render/math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace firstlight::parser {

/// The outlines of a TrueType font, as far as POV-Ray 3.7 reads them.
///
/// Units    Coordinates are in ems.
/// Safety   A font is untrusted: whatever lies beyond its end reads as 0, and parts of parts end at a depth.
/// Source   Apple, TrueType Reference Manual: tables cmap, glyf, head, hhea, hmtx, kern, loca.
class TrueTypeFont {
 public:
  struct Point {
    render::Vec2 at;
    bool on_curve;
  };
  struct Glyph {
    std::vector<std::vector<Point>> contours;
    double left = 0.0;     ///< the least x
    std::uint32_t metrics = 0;  ///< whose widths it has
  };

  /// `ascii`: which of several tables of characters is asked first. On failure `error` says why.
  TrueTypeFont(const std::string& path, bool ascii, std::string& error);

  /// 0: the font has no such character; its glyph then shows that.
  std::uint32_t glyph_of(std::uint32_t character) const;
  Glyph glyph(std::uint32_t index, bool blank) const;
  double advance(std::uint32_t index) const;
  double left_bearing(std::uint32_t index) const;
  /// An addition to the way from one glyph to the next.
  double kerning(std::uint32_t left, std::uint32_t right) const;

 private:
  std::uint32_t u8(std::size_t at) const { return at < bytes_.size() ? static_cast<std::uint8_t>(bytes_[at]) : 0u; }
  std::uint32_t u16(std::size_t at) const { return u8(at) << 8 | u8(at + 1); }
  int s16(std::size_t at) const { return static_cast<std::int16_t>(u16(at)); }
  std::uint32_t u32(std::size_t at) const { return u16(at) << 16 | u16(at + 2); }
  std::size_t table(const char* tag) const;
  void find_characters(bool ascii);
  std::size_t glyph_place(std::uint32_t index) const;
  void add_simple(std::size_t at, int contours, Glyph& glyph) const;
  void add_parts(std::size_t at, Glyph& glyph, int depth) const;
  Glyph outline(std::uint32_t index, int depth) const;

  std::string bytes_;
  std::size_t characters_ = 0;  ///< the subtable of cmap; 0: none
  std::size_t glyphs_ = 0;
  std::size_t places_ = 0;
  std::size_t widths_ = 0;
  std::size_t kerning_ = 0;
  bool long_places_ = false;
  std::uint32_t glyph_count_ = 0;
  std::uint32_t width_count_ = 0;
  double em_ = 1.0;
};

}  // namespace firstlight::parser
