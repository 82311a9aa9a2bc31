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

/// How many of a file's channels a Raster takes: the first ones, with alpha if it comes next.
int channels_of(const OIIO::ImageSpec& spec) {
  const int colors = spec.nchannels >= 3 ? 3 : 1;
  return spec.alpha_channel == colors ? colors + 1 : colors;
}

/// Reads as many channels of all pixels as samples of a type.
template <class Sample>
bool read(OIIO::ImageInput& input, Raster& raster, OIIO::TypeDesc type) {
  auto& samples = raster.samples.emplace<std::vector<Sample>>(static_cast<std::size_t>(raster.width) *
                                                              static_cast<std::size_t>(raster.height) *
                                                              static_cast<std::size_t>(raster.channels));
  return input.read_image(0, 0, 0, raster.channels, type, samples.data());
}

/// The part of OpenImageIO's message that says why; the rest goes on for lines.
std::string first_line(std::string text) {
  text.erase(std::min(text.find('\n'), text.size()));
  return text.empty() ? "unknown error" : text;
}

class OpenImageIoCodec final : public ImageCodec {
 public:
  std::vector<unsigned char> encode(std::string_view extension, const Pixels& pixels, std::string& error) const override
      try {
    const OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(pixels.width, pixels.height, pixels.channels, type);
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

  Raster decode(const std::string& path, std::string& error) const override try {
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
    Raster raster;
    raster.width = spec.width;
    raster.height = spec.height;
    raster.channels = channels_of(spec);
    bool done = false;
    if (spec.format.basesize() == 1) {
      done = read<std::uint8_t>(*input, raster, OIIO::TypeDesc::UINT8);
    } else if (spec.format.is_floating_point()) {
      raster.white = 1;
      raster.gamma = {FileGamma::Curve::power, 1.0};
      done = read<float>(*input, raster, OIIO::TypeDesc::FLOAT);
    } else {
      raster.white = 65535;
      done = read<std::uint16_t>(*input, raster, OIIO::TypeDesc::UINT16);
    }
    if (!done) {
      error = first_line(input->geterror());
      return {};
    }
    return raster;
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
