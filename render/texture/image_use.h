#pragma once

#include "render/function/function.h"
#include "render/image/image.h"
#include "render/math/vec.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::render {

/// A picture that a scene names, as file or as function over the unit square.
struct ImageSource {
  enum class Format { by_name, bmp, exr, gif, hdr, iff, jpeg, pgm, png, pot, ppm, sys, tga, tiff };
  /// How the file's numbers relate to light, when the scene says so.
  /// none: they are taken as they are.
  enum class Gamma { of_file, none, srgb, power };

  std::string path;                 ///< where the file was found
  Format format = Format::by_name;  ///< by_name: the name's extension tells
  Gamma gamma = Gamma::of_file;
  double gamma_exponent = 1.0;        ///< of Gamma::power: light = number ^ exponent
  std::optional<bool> premultiplied;  ///< colours are multiplied by alpha; not set: as the format has it
  FunctionPtr function;               ///< of x and y, instead of a file
  std::uint32_t columns = 0;          ///< of a picture made by a function; else 0
  std::uint32_t rows = 0;
  std::shared_ptr<const Image> image;  ///< null: not read
};

/// A picture laid on a surface. Defaults are POV-Ray 3.7's. [manual, "Image Map"]
struct ImageUse {
  enum class Projection { planar = 0, spherical = 1, cylindrical = 2, torus = 5 };
  enum class Interpolation { none = 0, bilinear = 2, bicubic = 3, normalized_distance = 4 };
  /// The part of a pixel that counts: its colour, its number in the palette, its alpha.
  enum class Part { color, index, alpha };
  struct PaletteChange {
    int entry = 0;
    double value = 0.0;
  };

  ImageSource source;
  Projection projection = Projection::planar;
  Interpolation interpolation = Interpolation::none;
  Part part = Part::color;
  bool once = false;  ///< not repeated beyond the unit square
  Vec2 repeat{1.0, 1.0};
  Vec2 offset{0.0, 0.0};             ///< in widths and heights of the picture
  std::optional<double> filter_all;  ///< of every colour
  std::optional<double> transmit_all;
  std::vector<PaletteChange> filters;  ///< of single entries of the palette, in order
  std::vector<PaletteChange> transmits;
};

}  // namespace firstlight::render
