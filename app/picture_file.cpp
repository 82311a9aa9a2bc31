#include "app/picture_file.h"

#include "render/film/preview.h"
#include "render/image/encode.h"
#include "render/image/image_io.h"
#include "render/image/link_target.h"
#include "render/scene/file_encoding.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <span>
#include <vector>

namespace firstlight::app {

std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings,
                       const FileNumbers& numbers) {
  render::Encoding encoding = render::file_encoding(settings);
  // Nothing is known of the numbers of a scene whose gamma is not managed, neither before nor after.
  const double gamma = settings.gamma == render::WorkingGamma::unmanaged ? 0.0 : numbers.gamma;
  if (gamma != 0.0) encoding = encoding.with_file_gamma(gamma);
  const auto width = static_cast<std::size_t>(film.width());
  // A complete picture has no holes to be filled, and goes to the file row by row: a large one is little more in memory
  // than its film.
  const bool is_complete = film.is_complete();
  std::vector<render::Rgb> filled;
  if (!is_complete) filled = render::preview(film);
  if (render::holds_light(path)) {
    if (is_complete) filled = film.snapshot();
    return render::write_light(path, film.width(), film.height(), render::to_light(filled, encoding));
  }
  render::ByteTable table(encoding);
  std::vector<render::Rgb> row(width);
  const auto make_row = [&](int y, std::span<std::uint8_t> rgb) {
    if (is_complete) film.row(y, row);
    const std::span<const render::Rgb> colors =
        is_complete ? std::span<const render::Rgb>(row)
                    : std::span<const render::Rgb>(filled).subspan(static_cast<std::size_t>(y) * width, width);
    numbers.bits == 8 ? table.encode(colors, rgb) : render::encode_words(colors, encoding, rgb);
  };
  return render::write_picture(
      path, render::PictureRows{film.width(), film.height(), make_row, numbers.bits / 8, gamma});
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
