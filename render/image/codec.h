#pragma once

#include "render/image/picture.h"

#include <string>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// Picture files of many kinds, to bytes and back. It lies in a module of its own, opened when the first picture is
/// read or written: OpenImageIO and what it needs take longer to load than many a scene takes to render.
///
/// Errors   Nothing is thrown: `error` says why, and the result is empty.
/// Threads  All members may be called from any thread.
class ImageCodec {
 public:
  /// Red green blue of each pixel, rows from the top.
  struct Pixels {
    int width = 0;
    int height = 0;
    bool light = false;          ///< floats of linear light, else bytes on the sRGB curve
    const void* data = nullptr;  ///< 3 * width * height of them
  };

  virtual ~ImageCodec() = default;
  /// The bytes of a file. `extension`: its kind, without a dot.
  virtual std::vector<unsigned char> encode(std::string_view extension, const Pixels& pixels,
                                            std::string& error) const = 0;
  virtual Picture decode(const std::string& path, std::string& error) const = 0;
};

/// The codec; opens the module unless that is done. Null when it cannot be opened: `error` says why.
const ImageCodec* image_codec(std::string& error);
/// Begins to open the module in the background, so that it is there when a picture is due. Until that is done, no other
/// thread can begin: the dynamic linker holds a lock.
void prepare_image_codec();

constexpr const char* kImageCodecModule = "firstlight_image_files.so";
constexpr const char* kImageCodecSymbol = "firstlight_image_codec";  ///< const ImageCodec* firstlight_image_codec()

}  // namespace firstlight::render
