#include "render/image/file_formats.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>
#include <utility>

namespace firstlight::render {
namespace {

/// libpng calls back with these. It leaves a failure by longjmp, over frames of C and of functions here that have
/// nothing to destroy: all that has lies in these structures, outside of the frame that setjmp is called in.
struct Failure {
  std::string why;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  static_cast<Failure*>(png_get_error_ptr(png))->why = message;
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Reading : Failure {
  explicit Reading(FileBytes bytes)
      : left(bytes),
        png(png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<Failure*>(this), on_error, on_warning)) {
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Reading(const Reading&) = delete;
  ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }

  FileBytes left;
  png_structp png;
  png_infop info = nullptr;
  int bits = 0;  ///< of a pixel, in the file
  Raster raster;
  std::vector<png_bytep> rows;
};

struct Writing : Failure {
  Writing(const PictureRows& rows, const PutBytes& to)
      : picture(rows),
        put(to),
        png(png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<Failure*>(this), on_error, on_warning)),
        row(rows.row_bytes()) {
    if (png != nullptr) info = png_create_info_struct(png);
  }
  Writing(const Writing&) = delete;
  ~Writing() { png_destroy_write_struct(&png, &info); }

  const PictureRows& picture;
  const PutBytes& put;
  png_structp png;
  png_infop info = nullptr;
  std::vector<std::uint8_t> row;
};

void take(png_structp png, png_bytep to, png_size_t count) {
  FileBytes& left = static_cast<Reading*>(png_get_io_ptr(png))->left;
  if (count > left.size()) png_error(png, kEndsTooEarly);
  std::memcpy(to, left.data(), count);
  left = left.subspan(count);
}

void put(png_structp png, png_bytep from, png_size_t count) {
  static_cast<Writing*>(png_get_io_ptr(png))->put({from, count});
}

/// Runs steps that have nothing to destroy; false when libpng failed in them.
template <class Steps>
bool guarded(png_structp png, Steps steps) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  steps();
  return true;
}

/// All up to the pixels, which libpng is asked for as bytes or words of this machine.
void read_header(Reading& r) {
  png_set_read_fn(r.png, &r, take);
  png_read_info(r.png, r.info);
  r.bits = png_get_channels(r.png, r.info) * png_get_bit_depth(r.png, r.info);
  if (png_get_color_type(r.png, r.info) == PNG_COLOR_TYPE_PALETTE) {
    png_set_packing(r.png);
  } else {
    png_set_expand(r.png);  // grey of few bits to 8, a transparent colour to alpha
    if constexpr (std::endian::native == std::endian::little) png_set_swap(r.png);
  }
  png_set_interlace_handling(r.png);
  png_read_update_info(r.png, r.info);
}

FileGamma gamma_of(Reading& r) {
  int intent = 0;
  double encoding = 0.0;
  if (png_get_sRGB(r.png, r.info, &intent) != 0) return {FileGamma::Curve::srgb, 1.0};
  if (png_get_gAMA(r.png, r.info, &encoding) != 0 && encoding > 0.0) return {FileGamma::Curve::power, 1.0 / encoding};
  return {};
}

std::vector<Raster::Color> palette_of(Reading& r) {
  png_colorp colors = nullptr;
  int count = 0;
  if (png_get_color_type(r.png, r.info) != PNG_COLOR_TYPE_PALETTE ||
      png_get_PLTE(r.png, r.info, &colors, &count) == 0) {
    return {};
  }
  png_bytep alphas = nullptr;
  int alpha_count = 0;
  png_get_tRNS(r.png, r.info, &alphas, &alpha_count, nullptr);
  std::vector<Raster::Color> palette;
  for (int i = 0; i < count; ++i) {
    const std::uint8_t alpha = alphas != nullptr && i < alpha_count ? alphas[i] : 255;
    palette.push_back({colors[i].red, colors[i].green, colors[i].blue, alpha});
  }
  return palette;
}

/// Makes room for the pixels, whose size and kind are known now.
void prepare_rows(Reading& r, std::size_t file_size) {
  Raster& raster = r.raster;
  const std::int64_t width = png_get_image_width(r.png, r.info);
  const std::int64_t height = png_get_image_height(r.png, r.info);
  check_size(width, height, file_size, 1032 * 8 / r.bits);  // deflate makes at most 1032 bytes of one
  raster.width = static_cast<int>(width);
  raster.height = static_cast<int>(height);
  raster.channels = png_get_channels(r.png, r.info);
  raster.gamma = gamma_of(r);
  raster.palette = palette_of(r);
  const std::size_t row = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.channels);
  const std::size_t samples = row * static_cast<std::size_t>(raster.height);
  png_bytep first = nullptr;
  if (png_get_bit_depth(r.png, r.info) == 16) {
    raster.white = 65535;
    first = reinterpret_cast<png_bytep>(raster.samples.emplace<Raster::Words>(samples).data());
  } else {
    first = raster.samples.emplace<Raster::Bytes>(samples).data();
  }
  const std::size_t stride = png_get_rowbytes(r.png, r.info);
  r.rows.reserve(static_cast<std::size_t>(raster.height));
  for (int y = 0; y < raster.height; ++y) r.rows.push_back(first + stride * static_cast<std::size_t>(y));
}

/// By the number of channels, from 1.
constexpr int kColorTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                               PNG_COLOR_TYPE_RGB_ALPHA};

/// Writing takes two fifths of the time that libpng's own choice takes, and the files are 6 % larger (docs/performance.md).
constexpr int kCompressionLevel = 4;
constexpr int kFilters = PNG_FILTER_NONE | PNG_FILTER_SUB | PNG_FILTER_UP;

void write_all(Writing& w) {
  const int width = w.picture.width;
  const int height = w.picture.height;
  png_set_write_fn(w.png, &w, put, nullptr);
  png_set_compression_level(w.png, kCompressionLevel);
  png_set_filter(w.png, PNG_FILTER_TYPE_BASE, kFilters);
  png_set_IHDR(w.png, w.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
               8 * w.picture.channel_bytes, kColorTypes[w.picture.channels - 1], PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (w.picture.bits != 8 * w.picture.channel_bytes) {
    const auto bits = static_cast<png_byte>(w.picture.bits);
    const png_color_8 significant{bits, bits, bits, bits, bits};
    png_set_sBIT(w.png, w.info, &significant);
  }
  if (w.picture.gamma == 0.0) {
    png_set_sRGB_gAMA_and_cHRM(w.png, w.info, PNG_sRGB_INTENT_ABSOLUTE);
  } else {
    png_set_gAMA(w.png, w.info, 1.0 / w.picture.gamma);
  }
  png_write_info(w.png, w.info);
  for (int y = 0; y < height; ++y) {
    w.picture.make(y, w.row);
    png_write_row(w.png, w.row.data());
  }
  png_write_end(w.png, nullptr);
}

}  // namespace

bool is_png(FileBytes file) { return file.size() >= 8 && png_sig_cmp(file.data(), 0, 8) == 0; }

Raster read_png(FileBytes file) {
  Reading r(file);
  if (r.info == nullptr) throw std::bad_alloc();
  const auto run = [&](auto steps) {
    if (!guarded(r.png, steps)) throw BrokenPicture(r.why);
  };
  run([&r] { read_header(r); });
  prepare_rows(r, file.size());
  run([&r] {
    png_read_image(r.png, r.rows.data());
    png_read_end(r.png, nullptr);
  });
  if (!r.raster.palette.empty()) {
    const Raster::Bytes& indices = std::get<Raster::Bytes>(r.raster.samples);
    if (*std::max_element(indices.begin(), indices.end()) >= r.raster.palette.size()) {
      throw BrokenPicture("a pixel's index is beyond the palette");
    }
  }
  return std::move(r.raster);
}

void make_png(const PictureRows& picture, const PutBytes& put) {
  Writing w(picture, put);
  if (w.info == nullptr) throw std::bad_alloc();
  if (!guarded(w.png, [&] { write_all(w); })) throw BrokenPicture(w.why);
}

}  // namespace firstlight::render
