#include "app/picture_file.h"

#include "render/film/preview.h"
#include "render/image/encode.h"
#include "render/image/image_io.h"
#include "render/image/link_target.h"
#include "render/scene/file_encoding.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace firstlight::app {

std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings) {
  const render::Encoding encoding = render::file_encoding(settings);
  const std::vector<render::Rgb> colors = render::preview(film);
  if (render::holds_light(path)) {
    return render::write_light(path, film.width(), film.height(), render::to_light(colors, encoding));
  }
  return render::write_picture(path, {film.width(), film.height(), render::to_bytes(colors, encoding)});
}

std::string check_writable(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const std::string path = render::link_target(name).string();
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::exists(folder, ignored))
    return fmt::format("cannot write '{}': there is no folder '{}'", path, folder.string());
  if (!fs::is_directory(folder, ignored))
    return fmt::format("cannot write '{}': '{}' is not a folder", path, folder.string());
  if (fs::is_directory(path, ignored)) return fmt::format("cannot write '{}': it is a folder", path);
  const bool replaceable = !fs::exists(path, ignored) || fs::is_regular_file(path, ignored);
  const int may_write = replaceable ? ::access(folder.c_str(), W_OK | X_OK) : ::access(path.c_str(), W_OK);
  return may_write == 0 ? "" : fmt::format("cannot write '{}': no permission to write there", path);
}

}  // namespace firstlight::app
