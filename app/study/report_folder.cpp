#include "app/study/report_folder.h"

#include "app/picture_file.h"
#include "app/stats.h"
#include "app/study/csv.h"
#include "app/study/report.h"
#include "app/study/thumbnail.h"
#include "render/image/image_io.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace firstlight::app {
namespace {

namespace fs = std::filesystem;

constexpr int kSmallSize = 240;           // pixels, the longer side of the report's pictures
constexpr std::size_t kLongestName = 40;  // of a scheme in a file's name

}  // namespace

std::string ReportFolder::prepare() const {
  std::error_code error;
  fs::create_directories(fs::path(path_) / "pictures", error);
  if (error) return fmt::format("cannot make the folder '{}': {}", path_, error.message());
  return check_writable(page());
}

std::string ReportFolder::keep_picture(std::size_t number, const std::string& scheme, double share,
                                       std::span<const render::Rgb> colors) {
  if (!error_.empty()) return {};
  const std::string stem = (fs::path(path_) / "pictures" / picture_name(number, scheme, share)).string();
  error_ = render::write_picture(stem + ".png", {width_, height_, render::to_bytes(colors, encoding_)});
  if (!error_.empty()) return {};
  const SmallPicture small = shrink(colors, width_, height_, kSmallSize);
  const std::string small_file = stem + ".small.png";
  error_ = render::write_picture(small_file, {small.width, small.height, render::to_bytes(small.colors, encoding_)});
  if (!error_.empty()) return {};
  std::ifstream stream(small_file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  stream.close();
  std::error_code ignored;
  fs::remove(small_file, ignored);
  return bytes;
}

std::string ReportFolder::write(const Study& study) const {
  for (const CsvFile& file : csv_files(study)) {
    if (std::string why = write_text_file((fs::path(path_) / file.name).string(), file.text); !why.empty()) return why;
  }
  return write_text_file(page(), report_html(study));
}

std::string ReportFolder::page() const { return (fs::path(path_) / "index.html").string(); }

std::string picture_name(std::size_t number, const std::string& scheme, double share) {
  std::string name;
  for (const char c : scheme.substr(0, kLongestName)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (plain) {
      name += c;
    } else if (!name.ends_with('-')) {
      name += '-';
    }
  }
  while (name.ends_with('-')) name.pop_back();
  return fmt::format("{:02}-{}-{:.0f}", number + 1, name, 100.0 * share);
}

}  // namespace firstlight::app
