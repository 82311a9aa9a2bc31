#pragma once

#include "render/image/picture.h"
#include "render/image/picture_rows.h"
#include "render/image/raster.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace firstlight::render {

// Writing. The picture is written under another name in the same folder and renamed when it is complete, so a file of
// the name is never half written, and a failure leaves what was there. The result is empty, or says in plain words why
// the picture could not be written. `format` is an extension without its dot and rules when given; else the path's
// extension does. Formats of 8 bits: png, tga, ppm, bmp, jpg; of linear light: exr, hdr.

/// The numbers that files of a kind can have besides 8 bits of red green blue.
struct FormatAbilities {
  bool alpha = false;
  bool grey = false;
  bool depths = false;   ///< 5 to 16 bits
  bool dithers = false;  ///< it is worth while to hide the steps between them
};
FormatAbilities abilities_of(const std::string& path);

/// Whether files of that kind hold linear light (write_light) instead of 8-bit values (write_picture).
bool holds_light(const std::string& path, std::string_view format = {});
std::string write_picture(const std::string& path, const Picture& picture, std::string_view format = {});
/// The same, and neither the picture nor the file is in memory as a whole where the format allows that: png, tga,
/// ppm, bmp.
std::string write_picture(const std::string& path, const PictureRows& picture, std::string_view format = {});
/// `light` holds the channels of each pixel, as PictureRows has them but that colours are multiplied by alpha; rows
/// from the top. Pre: channels * width * height numbers.
std::string write_light(const std::string& path, int width, int height, std::span<const float> light,
                        std::string_view format = {}, int channels = 3);
/// `rgb` as in Picture. Pre: 3 * width * height bytes.
std::string write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb);

/// Reads a file of any format that POV-Ray or OpenImageIO knows, told by what the file contains, with the file's own
/// depth and channels. On failure `error` says why and the raster is empty.
Raster read_raster(const std::string& path, std::string& error, Palette palette = Palette::resolve);
/// The same as 8-bit values: to_picture() of it.
Picture read_image(const std::string& path, std::string& error);

}  // namespace firstlight::render
