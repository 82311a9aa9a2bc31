#pragma once

#include "render/image/raster.h"

#include <string>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// Picture files of the kinds that are not at hand in file_formats.h, to bytes and back. It lies in a module of its
/// own, opened when the first such picture is read or written: OpenImageIO and the 250 libraries it needs take longer
/// to load than many a scene takes to render.
///
/// Errors   Nothing is thrown: `error` says why, and the result is empty.
/// Threads  All members may be called from any thread.
class ImageCodec {
 public:
  /// Linear light, rows from the top; colours are multiplied by alpha.
  struct Pixels {
    int width = 0;
    int height = 0;
    int channels = 3;             ///< 3: red green blue; 4: red green blue alpha
    const float* data = nullptr;  ///< channels * width * height of them
  };

  virtual ~ImageCodec() = default;
  /// The bytes of a file. `extension`: its kind, without a dot.
  virtual std::vector<unsigned char> encode(std::string_view extension, const Pixels& pixels,
                                            std::string& error) const = 0;
  virtual Raster decode(const std::string& path, std::string& error) const = 0;
};

/// The codec; opens the module unless that is done. Null when it cannot be opened: `error` says why.
const ImageCodec* image_codec(std::string& error);

constexpr const char* kImageCodecModule = "firstlight_image_files.so";
constexpr const char* kImageCodecSymbol = "firstlight_image_codec";  ///< const ImageCodec* firstlight_image_codec()

}  // namespace firstlight::render
