#include "app/compare/report/report.h"

#include "app/compare/content.h"
#include "app/compare/difference.h"
#include "app/compare/report/pages.h"
#include "app/picture_file.h"
#include "app/stats.h"
#include "app/study/thumbnail.h"
#include "render/image/encode.h"
#include "render/image/image_io.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kSmallSize = 200;         // pixels, the longer side of the table's pictures: twice what they are shown at
constexpr std::size_t kWorstShown = 8;  // pixels in a scene's table

std::string cannot(const char* what, const fs::path& path, const std::error_code& error) {
  return fmt::format("cannot {} '{}': {}", what, path.string(), error.message());
}

std::string write_png(const fs::path& path, const render::Picture& picture) {
  return render::write_png(path.string(), picture.width, picture.height, picture.rgb);
}

/// Each pixel is the mean of the file's own numbers.
render::Picture small_of(const render::Picture& picture) {
  std::vector<render::Rgb> colors;
  colors.reserve(picture.rgb.size() / 3);
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
    colors.emplace_back(static_cast<float>(picture.rgb[i]) / 255.0f, static_cast<float>(picture.rgb[i + 1]) / 255.0f,
                        static_cast<float>(picture.rgb[i + 2]) / 255.0f);
  }
  const SmallPicture small = shrink(colors, picture.width, picture.height, kSmallSize);
  return {small.width, small.height, render::to_bytes(small.colors, render::Encoding::as_is())};
}

/// A folder beside the one that is to be, which is removed unless it takes that one's place.
class Beside {
 public:
  explicit Beside(const fs::path& folder)
      : folder_(folder), part_(folder.string() + fmt::format(".{}.part", ::getpid())) {}
  ~Beside() {
    std::error_code ignored;
    fs::remove_all(part_, ignored);
  }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  const fs::path& path() const { return part_; }

  std::string take_place() {
    std::error_code error;
    const fs::path old = folder_.string() + fmt::format(".{}.old", ::getpid());
    const bool replaces = fs::exists(folder_, error);
    if (replaces) fs::rename(folder_, old, error);
    if (error) return cannot("replace", folder_, error);
    fs::rename(part_, folder_, error);
    std::error_code ignored;
    if (error && replaces) fs::rename(old, folder_, ignored);
    if (error) return cannot("write", folder_, error);
    if (replaces) fs::remove_all(old, ignored);
    return {};
  }

 private:
  const fs::path folder_;
  const fs::path part_;
};

class Writer {
 public:
  Writer(const fs::path& folder, const ReportContent& content) : folder_(folder), content_(content) {}

  std::string run() {
    std::error_code error;
    for (const char* name : {"scenes", "pictures"}) {
      fs::create_directories(folder_ / name, error);
      if (error) return cannot("make the folder", folder_ / name, error);
    }
    for (std::size_t i = 0; i < content_.records.size(); ++i) {
      SceneFiles files;
      files.stem = file_stem(i + 1, content_.records[i].name);
      if (std::string why = write_pictures(content_.records[i], files); !why.empty()) return why;
      files_.push_back(std::move(files));
    }
    for (std::size_t i = 0; i < files_.size(); ++i) {
      std::string why = write_text_file((folder_ / files_[i].page()).string(), scene_page(content_, files_, i));
      if (!why.empty()) return why;
    }
    return write_text_file((folder_ / "index.html").string(), index_page(content_, files_));
  }

 private:
  /// Pictures are written anew, not copied: a program's own notes on gamma would have browsers show them differently.
  std::string write_pictures(const SceneRecord& record, SceneFiles& files) const {
    if (!record.difference) return {};
    std::string why;
    const render::Picture theirs = render::read_image(record.povray_picture.string(), why);
    if (!why.empty()) return why;
    const render::Picture own = render::read_image(record.our_picture.string(), why);
    if (!why.empty()) return why;
    if (theirs.width != own.width || theirs.height != own.height) {
      return fmt::format("'{}' has changed since it was compared", record.our_picture.string());
    }
    const render::Picture difference = difference_map(theirs, own);
    for (const auto& [kind, picture] :
         {std::pair("povray", &theirs), std::pair("firstlight", &own), std::pair("difference", &difference)}) {
      why = write_png(folder_ / files.picture(kind), *picture);
      if (why.empty()) why = write_png(folder_ / files.picture(std::string(kind) + "-small"), small_of(*picture));
      if (!why.empty()) return why;
    }
    files.has_pictures = true;
    files.width = own.width;
    files.height = own.height;
    files.worst = worst_places(theirs, own, kWorstShown);
    return write_png(folder_ / files.picture("flip"), flip_map(theirs, own));
  }

  const fs::path& folder_;
  const ReportContent& content_;
  std::vector<SceneFiles> files_;
};

/// Without a slash at its end, so that names can be put behind it.
fs::path plain(const fs::path& folder) {
  const fs::path normal = fs::absolute(folder).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

std::string check_report_folder(const fs::path& given) {
  const fs::path folder = plain(given);
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    return fmt::format("cannot write the report '{}': there is a file of that name", given.string());
  }
  if (fs::exists(status) && !fs::is_empty(folder, error)) {
    const bool is_report = read_bytes(folder / "index.html").find(kReportMark) != std::string::npos;
    if (!is_report) {
      return fmt::format("cannot write the report '{}': the folder holds something that is no report", given.string());
    }
  }
  fs::create_directories(folder.parent_path(), error);
  if (error) return cannot("make the folder", folder.parent_path(), error);
  if (::access(folder.parent_path().c_str(), W_OK | X_OK) != 0) {
    return fmt::format("cannot write the report '{}': no permission to write to '{}'", given.string(),
                       folder.parent_path().string());
  }
  return {};
}

std::string write_report(const fs::path& given, const ReportContent& content) {
  if (std::string why = check_report_folder(given); !why.empty()) return why;
  Beside beside(plain(given));
  std::string why = Writer(beside.path(), content).run();
  return why.empty() ? beside.take_place() : why;
}

}  // namespace firstlight::app::compare
