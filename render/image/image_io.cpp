#include "render/image/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
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

namespace firstlight::render {
namespace {

namespace fs = std::filesystem;

struct Format {
  std::string_view extension;
  bool light;  ///< linear light in floats, else 8 bits on the sRGB curve
};

constexpr std::array kFormats = {Format{"png", false}, Format{"tga", false}, Format{"ppm", false},
                                 Format{"bmp", false}, Format{"jpg", false}, Format{"jpeg", false},
                                 Format{"exr", true},  Format{"hdr", true}};

/// Pictures with more pixels than this are taken for damaged files.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

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

/// The part of OpenImageIO's message that says why; the rest goes on for lines.
std::string first_line(std::string text) {
  text.erase(std::min(text.find('\n'), text.size()));
  return text.empty() ? "unknown error" : text;
}

/// The bytes of the picture file, made by OpenImageIO. They are made in memory, for OpenImageIO does not report a disk
/// that is full. On failure `error` says why.
std::vector<unsigned char> file_bytes(const Format& format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                                      const void* pixels, std::string& error) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(std::string(format.extension));
  if (!output) {
    error = first_line(OIIO::geterror());
    return {};
  }
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::string name = fmt::format("picture.{}", format.extension);  // its extension is looked at
  const bool done = output->set_ioproxy(&memory) && output->open(name, spec) && output->write_image(type, pixels);
  if (!output->close() || !done) error = first_line(output->geterror());
  return bytes;
}

/// Writes a whole file; the system's reason when that fails, else empty. `is_new`: the file must not exist yet.
std::string write_file(const fs::path& path, std::span<const unsigned char> bytes, bool is_new) {
  std::FILE* const file = std::fopen(path.c_str(), is_new ? "wbx" : "wb");
  if (file == nullptr) return std::generic_category().message(errno);
  int failure = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
  if (std::fflush(file) != 0 && failure == 0) failure = errno;
  if (std::fclose(file) != 0 && failure == 0) failure = errno;
  return failure == 0 ? "" : std::generic_category().message(failure);
}

std::string write(const std::string& path, const Format& format, int width, int height, OIIO::TypeDesc type,
                  const void* pixels) {
  if (width <= 0 || height <= 0) return refusal(path, "the picture has no pixels");
  std::error_code ignored;
  fs::path target(path);
  if (!target.has_filename()) return refusal(path, "that names a folder, not a file");
  if (target.has_parent_path() && !fs::is_directory(target.parent_path(), ignored)) {
    return refusal(path, fmt::format("there is no folder '{}'", target.parent_path().string()));
  }
  // A link stays a link: the file it points to is replaced.
  if (fs::is_symlink(target, ignored)) {
    const fs::path pointed = fs::weakly_canonical(target, ignored);
    if (!ignored) target = pointed;
  }
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) return refusal(path, "that is a folder");

  OIIO::ImageSpec spec(width, height, 3, type);
  if (!format.light) spec.attribute("oiio:ColorSpace", "sRGB");
  if (format.extension.starts_with("jp")) spec.attribute("CompressionQuality", 95);

  // What exists and is no plain file, such as /dev/null, cannot be replaced by renaming.
  const bool in_place = fs::exists(status) && !fs::is_regular_file(status);
  std::string error;
  const std::vector<unsigned char> bytes = file_bytes(format, spec, type, pixels, error);
  if (!error.empty()) return refusal(path, error);
  if (in_place) {
    error = write_file(target, bytes, false);
    return error.empty() ? "" : refusal(path, error);
  }
  const fs::path temporary = temporary_beside(target);
  error = write_file(temporary, bytes, true);
  if (error.empty()) {
    std::error_code failed;
    fs::rename(temporary, target, failed);
    if (!failed) return {};
    error = failed.message();
  }
  fs::remove(temporary, ignored);
  return refusal(path, error);
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

bool holds_light(const std::string& path, std::string_view format) {
  const Format* const found = find_format(path, format);
  return found != nullptr && found->light;
}

std::string write_picture(const std::string& path, const Picture& picture, std::string_view format) {
  return guarded(path, [&] {
    const Format* const found = find_format(path, format);
    if (found == nullptr) return unknown_format(path);
    if (found->light) return refusal(path, "that format holds light, not 8-bit values");
    return write(path, *found, picture.width, picture.height, OIIO::TypeDesc::UINT8, picture.rgb.data());
  });
}

std::string write_light(const std::string& path, int width, int height, std::span<const float> light,
                        std::string_view format) {
  return guarded(path, [&] {
    const Format* const found = find_format(path, format);
    if (found == nullptr) return unknown_format(path);
    if (!found->light) return refusal(path, "that format holds 8-bit values, not light");
    return write(path, *found, width, height, OIIO::TypeDesc::FLOAT, light.data());
  });
}

std::string write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
  return guarded(path, [&] { return write(path, kFormats.front(), width, height, OIIO::TypeDesc::UINT8, rgb.data()); });
}

Picture read_image(const std::string& path, std::string& error) {
  error.clear();
  const auto fail = [&](std::string_view why) {
    error = fmt::format("cannot read '{}': {}", path, why);
    return Picture();
  };
  try {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) return fail("there is no such file");
    if (!fs::is_regular_file(status)) return fail("that is not a file");
    OIIO::ImageSpec options;
    options.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, not darkened by alpha
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &options);
    if (!input) return fail(first_line(OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 ||
        std::int64_t{spec.width} * spec.height > kMostPixels) {
      return fail("its size is not that of a picture");
    }
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    const int channels = spec.nchannels >= 3 ? 3 : 1;
    Picture picture{spec.width, spec.height, std::vector<std::uint8_t>(pixels * 3)};
    // One channel is read to every third byte and copied to its neighbours.
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, picture.rgb.data(), 3)) {
      return fail(first_line(input->geterror()));
    }
    if (channels == 1) {
      for (std::size_t i = 0; i < picture.rgb.size(); i += 3) picture.rgb[i + 1] = picture.rgb[i + 2] = picture.rgb[i];
    }
    return picture;
  } catch (const std::exception& problem) {
    return fail(problem.what());
  }
}

}  // namespace firstlight::render
