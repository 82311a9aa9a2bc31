#pragma once

#include "render/math/vec.h"

#include <string>

namespace firstlight::render {

/// A line of letters along the x axis, from z = 0 to z = `thickness`.
struct TextForm {
  std::string font_file;  ///< a TrueType font; empty: a built-in one
  int builtin_font = 0;   ///< 0: the logo, 1: like Times, 2: like Helvetica, 3: like Courier
  std::string text;       ///< UTF-8
  double thickness = 1.0;
  Vec3 offset{0.0, 0.0, 0.0};  ///< added to the way from each letter to the next
};

}  // namespace firstlight::render
