#pragma once

#include "render/image/picture_rows.h"
#include "render/image/raster.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

namespace firstlight::render {

// The formats of picture files that are at hand without the module of codec.h; image_io.cpp has the table of them.
// A read_ function gives the indices of a picture with a palette; whoever wants colours resolves it. What is wrong with
// a file is thrown as BrokenPicture, for image_io.cpp to catch.

using FileBytes = std::span<const std::uint8_t>;

class BrokenPicture : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr const char* kEndsTooEarly = "the file ends too early";
constexpr const char* kNoSize = "its size is not that of a picture";

/// Throws unless a file of `bytes` can hold as many pixels, before there is memory spent on what is not there.
/// `pixels_a_byte`: how many of them the format can get out of a byte of the file.
void check_size(std::int64_t width, std::int64_t height, std::size_t bytes, std::int64_t pixels_a_byte);

bool is_png(FileBytes file);
bool is_jpeg(FileBytes file);
bool is_gif(FileBytes file);
bool is_hdr(FileBytes file);
bool is_pnm(FileBytes file);  ///< P1 to P6: bitmaps, grey and colour, as text or binary
bool is_tga(FileBytes file);  ///< It has no mark of its own: whether its header makes sense.

Raster read_png(FileBytes file);
Raster read_jpeg(FileBytes file);
Raster read_gif(FileBytes file);
Raster read_hdr(FileBytes file);
Raster read_pnm(FileBytes file);
Raster read_tga(FileBytes file);

/// Takes the bytes of a file, one part after the other.
using PutBytes = std::function<void(FileBytes part)>;

// Make a file of a picture that has pixels.
void make_png(const PictureRows& picture, const PutBytes& put);
void make_jpeg(const PictureRows& picture, const PutBytes& put);
void make_ppm(const PictureRows& picture, const PutBytes& put);
void make_tga(const PictureRows& picture, const PutBytes& put);
void make_bmp(const PictureRows& picture, const PutBytes& put);

}  // namespace firstlight::render
