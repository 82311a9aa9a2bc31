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
#include <type_traits>
#include <vector>

namespace firstlight::app {

namespace {

/// Leaves out what the file's format cannot have; in shades of grey it has all the bits that heights need.
void keep_to_abilities(const render::FormatAbilities& can, FileForm& form) {
  render::FileNumbers& numbers = form.numbers;
  numbers.alpha &= can.alpha;
  numbers.grey &= can.grey;
  if (!can.depths) numbers.bits = 8;
  if (numbers.grey) numbers.bits = 16;
  if (!can.dithers) numbers.dithering = render::Dithering::none;
}

template <class Color>
std::vector<Color> preview_of(const render::Film& film) {
  if constexpr (std::is_same_v<Color, render::Rgb>) {
    return render::preview(film);
  } else {
    return render::preview_with_alpha(film);
  }
}

template <class Color>
std::string write_film_as(const std::string& path, const render::Film& film, const render::Encoding& encoding,
                          const FileForm& form) {
  const render::FileNumbers& numbers = form.numbers;
  const auto width = static_cast<std::size_t>(film.width());
  // A complete picture has no holes to be filled, and goes to the file row by row: a large one is little more in memory
  // than its film.
  const bool is_complete = film.is_complete();
  std::vector<Color> filled;
  if (!is_complete) filled = preview_of<Color>(film);
  std::vector<Color> room(width);
  const auto row_at = [&](int y) -> std::span<const Color> {
    if (!is_complete) return std::span(filled).subspan(static_cast<std::size_t>(y) * width, width);
    film.row(y, room);
    return room;
  };
  if (render::holds_light(path)) {
    std::vector<float> light;
    light.reserve(film.pixels() * static_cast<std::size_t>(numbers.channels()));
    for (int y = 0; y < film.height(); ++y) render::append_light(row_at(y), encoding, numbers, light);
    return render::write_light(path, film.width(), film.height(), light, {}, numbers.channels());
  }
  // Files in shades of grey without more bits are read as they are. [POV-Ray 3.7]
  const bool is_pnm = !render::abilities_of(path).alpha;
  render::RowEncoder encoder(numbers.grey && is_pnm ? render::Encoding::as_is() : encoding, numbers, film.width(),
                             /*fills=*/!is_pnm);
  const auto make_row = [&](int y, std::span<std::uint8_t> bytes) { encoder.encode(y, row_at(y), bytes); };
  return render::write_picture(path, render::PictureRows{.width = film.width(),
                                                         .height = film.height(),
                                                         .make = make_row,
                                                         .channels = numbers.channels(),
                                                         .channel_bytes = numbers.channel_bytes(),
                                                         .bits = numbers.bits,
                                                         .gamma = numbers.gamma,
                                                         .quality = form.quality,
                                                         .runs = form.runs});
}

}  // namespace

std::string write_film(const std::string& path, const render::Film& film, const render::Settings& settings,
                       FileForm form) {
  render::Encoding encoding = render::file_encoding(settings);
  // Nothing is known of the numbers of a scene whose gamma is not managed, neither before nor after.
  render::FileNumbers& numbers = form.numbers;
  if (settings.gamma == render::WorkingGamma::unmanaged) numbers.gamma = 0.0;
  if (numbers.gamma != 0.0) encoding = encoding.with_file_gamma(numbers.gamma);
  numbers.alpha &= film.has_alpha();
  keep_to_abilities(render::abilities_of(path), form);
  return numbers.alpha ? write_film_as<render::PixelColor>(path, film, encoding, form)
                       : write_film_as<render::Rgb>(path, film, encoding, form);
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
