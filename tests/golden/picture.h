#pragma once
#include "app/compare/difference.h"
#include "app/compare/record_text.h"
#include "render/image/image_io.h"

#include <filesystem>
#include <optional>
#include <string>

namespace firstlight::golden {

using app::compare::difference;
using app::compare::PictureDifference;
using render::Picture;

/// Nothing when the file cannot be read as a picture; `why` then says so.
inline std::optional<Picture> read_picture(const std::filesystem::path& file, std::string& why) {
  Picture picture = render::read_image(file.string(), why);
  return why.empty() ? std::optional(std::move(picture)) : std::nullopt;
}

}  // namespace firstlight::golden
