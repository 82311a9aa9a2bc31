#pragma once

#include "render/image/image.h"
#include "render/texture/image_use.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace firstlight::render {

/// The meaning of a scene's numbers, as far as it has said where a picture is named.
struct ImageGamma {
  /// How a file is read that does not say what its numbers mean.
  /// none: they are taken as they are. scene: they are the scene's. format: by what is usual for its format.
  enum class Unstated { none, scene, format };

  Unstated unstated = Unstated::format;
  TransferCurve scene;
};

/// A picture's file as it is; of a continuous potential its grey of 16 bits. An `error` says why not in plain words.
Raster read_raster(const ImageSource& source, std::string& error);

/// The pictures of a scene, each read once.
///
/// Memory   Pictures are kept as long as the store or their users; all together have at most kMostBytes of pixels.
class ImageStore {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 31;

  /// The picture of a source; of a function, which is asked for each pixel here. Null: `error` says why in plain words.
  std::shared_ptr<const Image> load(const ImageSource& source, const ImageGamma& gamma, int noise_generator,
                                    std::string& error);

 private:
  bool take_room(std::uint64_t bytes, std::string& error);

  std::map<std::string, std::shared_ptr<const Image>> images_;  // by path and all that changes its numbers
  std::uint64_t bytes_ = 0;
};

}  // namespace firstlight::render
