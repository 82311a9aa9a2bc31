#include "render/image/image_io.h"

#include "render/image/codec.h"
#include "render/image/file_formats.h"
#include "render/image/link_target.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace firstlight::render {
namespace {

namespace fs = std::filesystem;

struct Format {
  using Make = void (*)(const PictureRows& picture, const PutBytes& put);

  std::string_view extension;
  bool light = false;   ///< linear light in floats, else whole numbers
  Make make = nullptr;  ///< its files; without it, the module
  FormatAbilities abilities = {};
};

constexpr std::array kFormats = {
    Format{"png", false, make_png, {.alpha = true, .grey = true, .depths = true, .dithers = true}},
    Format{"tga", false, make_tga, {.alpha = true, .dithers = true}},
    Format{"ppm", false, make_ppm, {.grey = true, .depths = true, .dithers = true}},
    Format{"bmp", false, make_bmp, {.alpha = true, .dithers = true}},
    Format{"jpg", false, make_jpeg},
    Format{"jpeg", false, make_jpeg},
    Format{"exr", true, nullptr, {.alpha = true}},
    Format{"hdr", true}};

/// Told by what they contain, in this order; what none of them claims is the module's.
struct Reader {
  bool (*claims)(FileBytes file);
  Raster (*read)(FileBytes file);
};

constexpr std::array kReaders = {Reader{is_png, read_png}, Reader{is_jpeg, read_jpeg}, Reader{is_gif, read_gif},
                                 Reader{is_hdr, read_hdr}, Reader{is_pnm, read_pnm},   Reader{is_tga, read_tga}};

const Format* find_format(const std::string& path, std::string_view format) {
  std::string extension(format);
  if (extension.empty()) {
    extension = fs::path(path).extension().string();
    if (!extension.empty()) extension.erase(0, 1);
  }
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& known) { return known.extension == extension; });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string refusal(const std::string& path, std::string_view why) {
  return fmt::format("cannot write '{}': {}", path, why);
}

std::string unknown_format(const std::string& path) {
  return refusal(path, "the picture format is not known; use .png, .tga, .ppm, .bmp, .jpg, .exr or .hdr");
}

/// Where to write until the picture is complete: hidden, in the same folder, of a name no other write uses.
fs::path temporary_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() / fmt::format(".firstlight-{}-{}.part", static_cast<long>(::getpid()), count++);
}

/// Writes a whole file: `make` has it, part by part. The system's reason when that fails, or make's, else empty.
/// `is_new`: the file must not exist yet.
template <class Make>
std::string write_file(const fs::path& path, bool is_new, const Make& make) {
  std::FILE* const file = std::fopen(path.c_str(), is_new ? "wbx" : "wb");
  if (file == nullptr) return std::generic_category().message(errno);
  int failure = 0;
  const auto put = [&](FileBytes part) {
    if (failure == 0 && std::fwrite(part.data(), 1, part.size(), file) != part.size()) failure = errno;
  };
  std::string error;
  try {
    error = make(put);
  } catch (const std::exception& problem) {
    error = problem.what();
  }
  if (std::fflush(file) != 0 && failure == 0) failure = errno;
  if (std::fclose(file) != 0 && failure == 0) failure = errno;
  return failure == 0 || !error.empty() ? error : std::generic_category().message(failure);
}

/// Has the module make a file. Empty, or why that failed.
std::string make_by_module(const Format& format, const ImageCodec::Pixels& pixels, const PutBytes& put) {
  std::string error;
  const ImageCodec* const codec = image_codec(error);
  if (codec == nullptr) return error;
  const std::vector<std::uint8_t> bytes = codec->encode(format.extension, pixels, error);
  if (error.empty()) put(bytes);
  return error;
}

template <class Make>
std::string write(const std::string& path, int width, int height, const Make& make) {
  if (width <= 0 || height <= 0) return refusal(path, "the picture has no pixels");
  std::error_code ignored;
  // A link stays a link: the file it points to is made or replaced.
  const fs::path target = link_target(path);
  if (!target.has_filename()) return refusal(path, "that names a folder, not a file");
  if (target.has_parent_path() && !fs::is_directory(target.parent_path(), ignored)) {
    return refusal(path, fmt::format("there is no folder '{}'", target.parent_path().string()));
  }
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) return refusal(path, "that is a folder");

  // Renaming cannot replace a target that exists and is no plain file, such as /dev/null.
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  std::string error;
  if (in_place) {
    error = write_file(target, false, make);
    return error.empty() ? "" : refusal(path, error);
  }
  const fs::path temporary = temporary_beside(target);
  error = write_file(temporary, true, make);
  if (error.empty()) {
    std::error_code failed;
    fs::rename(temporary, target, failed);
    if (!failed) return {};
    error = failed.message();
  }
  fs::remove(temporary, ignored);
  return refusal(path, error);
}

/// A whole file. `error` says why it cannot be read.
std::vector<std::uint8_t> read_file(const fs::path& path, std::string& error) {
  constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 31;
  const std::uintmax_t size = fs::file_size(path);
  if (size > kMostBytes) {
    error = "it is too large for a picture";
    return {};
  }
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    error = std::generic_category().message(errno);
    return {};
  }
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  if (std::ferror(file) != 0) error = std::generic_category().message(errno);
  std::fclose(file);
  return bytes;
}

/// `error` says why there is no picture. Its palette is left.
Raster decode(const std::string& path, std::string& error) {
  {
    const std::vector<std::uint8_t> bytes = read_file(path, error);
    if (!error.empty()) return {};
    for (const Reader& reader : kReaders) {
      if (reader.claims(bytes)) return reader.read(bytes);
    }
  }
  const ImageCodec* const codec = image_codec(error);
  return codec == nullptr ? Raster() : codec->decode(path, error);
}

/// Runs `action`; what the libraries below throw (out of memory, names the system refuses) becomes a message.
template <class Action>
std::string guarded(const std::string& path, Action action) {
  try {
    return action();
  } catch (const std::exception& problem) {
    return refusal(path, problem.what());
  }
}

}  // namespace

FormatAbilities abilities_of(const std::string& path) {
  const Format* const found = find_format(path, {});
  return found != nullptr ? found->abilities : FormatAbilities();
}

bool holds_light(const std::string& path, std::string_view format) {
  const Format* const found = find_format(path, format);
  return found != nullptr && found->light;
}

std::string write_picture(const std::string& path, const Picture& picture, std::string_view format) {
  return write_picture(path, rows_of(picture), format);
}

std::string write_picture(const std::string& path, const PictureRows& picture, std::string_view format) {
  return guarded(path, [&] {
    const Format* const found = find_format(path, format);
    if (found == nullptr) return unknown_format(path);
    if (found->light) return refusal(path, "that format holds light, not 8-bit values");
    return write(path, picture.width, picture.height, [&](const PutBytes& put) -> std::string {
      found->make(picture, put);
      return {};
    });
  });
}

std::string write_light(const std::string& path, int width, int height, std::span<const float> light,
                        std::string_view format, int channels) {
  return guarded(path, [&] {
    const Format* const found = find_format(path, format);
    if (found == nullptr) return unknown_format(path);
    if (!found->light) return refusal(path, "that format holds 8-bit values, not light");
    return write(path, width, height, [&](const PutBytes& put) {
      return make_by_module(*found, {width, height, channels, light.data()}, put);
    });
  });
}

std::string write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
  return write_picture(path, rows_of(width, height, rgb), "png");
}

Raster read_raster(const std::string& path, std::string& error, Palette palette) {
  error.clear();
  const auto fail = [&](std::string_view why) {
    error = fmt::format("cannot read '{}': {}", path, why);
    return Raster();
  };
  try {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return fail("there is no such file");
    if (!fs::is_regular_file(status)) return fail("that is not a file");
    std::string why;
    Raster raster = decode(path, why);
    if (!why.empty()) return fail(why);
    if (palette == Palette::resolve && !raster.palette.empty()) resolve_palette(raster);
    return raster;
  } catch (const std::exception& problem) {
    return fail(problem.what());
  }
}

Picture read_image(const std::string& path, std::string& error) {
  Raster raster = read_raster(path, error);
  return error.empty() ? to_picture(std::move(raster)) : Picture();
}

}  // namespace firstlight::render
