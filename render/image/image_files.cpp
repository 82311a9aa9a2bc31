// The module that codec.h speaks of: picture files by OpenImageIO.

#include "render/image/codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>

namespace firstlight::render {
namespace {

/// Pictures with more pixels than this are taken for damaged files.
constexpr std::int64_t kMostPixels = std::int64_t{1} << 28;

/// The part of OpenImageIO's message that says why; the rest goes on for lines.
std::string first_line(std::string text) {
  text.erase(std::min(text.find('\n'), text.size()));
  return text.empty() ? "unknown error" : text;
}

class OpenImageIoCodec final : public ImageCodec {
 public:
  std::vector<unsigned char> encode(std::string_view extension, const Pixels& pixels, std::string& error) const override
      try {
    const OIIO::TypeDesc type = pixels.light ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(pixels.width, pixels.height, 3, type);
    if (!pixels.light) spec.attribute("oiio:ColorSpace", "sRGB");
    if (extension.starts_with("jp")) spec.attribute("CompressionQuality", 95);
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(std::string(extension));
    if (!output) {
      error = first_line(OIIO::geterror());
      return {};
    }
    // Made in memory, for OpenImageIO does not report a disk that is full.
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = fmt::format("picture.{}", extension);  // its extension is looked at
    const bool done =
        output->set_ioproxy(&memory) && output->open(name, spec) && output->write_image(type, pixels.data);
    if (!output->close() || !done) {
      error = first_line(output->geterror());
      return {};
    }
    return bytes;
  } catch (const std::exception& problem) {
    error = problem.what();
    return {};
  }

  Picture decode(const std::string& path, std::string& error) const override try {
    OIIO::ImageSpec options;
    options.attribute("oiio:UnassociatedAlpha", 1);  // colours as stored, not darkened by alpha
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &options);
    if (!input) {
      error = first_line(OIIO::geterror());
      return {};
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 ||
        std::int64_t{spec.width} * spec.height > kMostPixels) {
      error = "its size is not that of a picture";
      return {};
    }
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    const int channels = spec.nchannels >= 3 ? 3 : 1;
    Picture picture{spec.width, spec.height, std::vector<std::uint8_t>(pixels * 3)};
    // One channel is read to every third byte and copied to its neighbours.
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, picture.rgb.data(), 3)) {
      error = first_line(input->geterror());
      return {};
    }
    if (channels == 1) {
      for (std::size_t i = 0; i < picture.rgb.size(); i += 3) picture.rgb[i + 1] = picture.rgb[i + 2] = picture.rgb[i];
    }
    return picture;
  } catch (const std::exception& problem) {
    error = problem.what();
    return {};
  }
};

}  // namespace
}  // namespace firstlight::render

extern "C" const firstlight::render::ImageCodec* firstlight_image_codec() {
  static const firstlight::render::OpenImageIoCodec codec;
  return &codec;
}
