#include "app/compare/kept.h"

#include "app/compare/content.h"
#include "app/compare/kept_json.h"
#include "app/compare/record_json.h"
#include "app/stats.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kPovrayPicture = "povray.png";
constexpr const char* kOurPicture = "firstlight.png";
constexpr const char* kFile = "result.json";

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::string cannot(const fs::path& path, const std::error_code& error) {
  return fmt::format("cannot write '{}': {}", path.string(), error.message());
}

/// Removed at the end unless it was renamed.
struct Scratch {
  fs::path path;
  ~Scratch() {
    std::error_code ignored;
    if (!path.empty()) fs::remove_all(path, ignored);
  }
};

/// `scratch` takes the place of `folder`, and of what was kept there before.
std::string put_in_place(const fs::path& scratch, const fs::path& folder) {
  std::error_code error;
  fs::rename(scratch, folder, error);
  if (!error) return {};
  fs::remove_all(folder, error);
  fs::rename(scratch, folder, error);
  return error ? cannot(folder, error) : std::string();
}

/// Null when it cannot be read.
Json read_json(const fs::path& file) {
  if (!is_file(file)) return nullptr;
  Json json = Json::parse(read_bytes(file), nullptr, false);
  return json.is_discarded() ? Json(nullptr) : json;
}

}  // namespace

std::string KeptResults::prepare() const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return fmt::format("cannot make the folder '{}': {}", folder_.string(), error.message());
  if (::access(folder_.c_str(), W_OK | X_OK) != 0) {
    return fmt::format("cannot write to the folder '{}'", folder_.string());
  }
  return {};
}

std::optional<Rendered> KeptResults::povray(const std::string& key) const try {
  const fs::path folder = folder_of_povray(key);
  const Json json = read_json(folder / kFile);
  if (json.is_null()) return std::nullopt;
  Rendered rendered;
  json.at("error").get_to(rendered.error);
  for (const Json& run : json.at("runs")) rendered.runs.push_back(run_of(run));
  if (json.at("picture").get<bool>()) {
    rendered.picture = folder / kPovrayPicture;
    if (!is_file(rendered.picture)) return std::nullopt;
  }
  return rendered;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

std::optional<SceneRecord> KeptResults::record(const std::string& key) const {
  std::optional<SceneRecord> record = record_of(read_json(folder_of_record(key) / kFile));
  if (!record) return std::nullopt;
  for (const fs::path& picture : {record->povray_picture, record->our_picture}) {
    if (!picture.empty() && !is_file(picture)) return std::nullopt;
  }
  return record;
}

std::string KeptResults::make_scratch(fs::path& scratch) const {
  std::string path = (folder_ / "part-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) return cannot(folder_, {errno, std::generic_category()});
  scratch = path;
  return {};
}

std::string KeptResults::keep_povray(const std::string& key, const Rendered& povray) const {
  Scratch scratch;
  if (std::string why = make_scratch(scratch.path); !why.empty()) return why;
  Json json;
  json["error"] = povray.error;
  json["runs"] = Json::array();
  for (const ProgramRun& run : povray.runs) json["runs"].push_back(to_json(run));
  json["picture"] = !povray.picture.empty();
  std::error_code error;
  if (!povray.picture.empty()) fs::copy_file(povray.picture, scratch.path / kPovrayPicture, error);
  if (error) return cannot(scratch.path / kPovrayPicture, error);
  if (std::string why = write_text_file((scratch.path / kFile).string(), text_of(json)); !why.empty()) return why;
  return put_in_place(scratch.path, folder_of_povray(key));
}

std::string KeptResults::keep_record(const std::string& key, SceneRecord& record) const {
  Scratch scratch;
  if (std::string why = make_scratch(scratch.path); !why.empty()) return why;
  const fs::path folder = folder_of_record(key);
  std::error_code error;
  if (!record.our_picture.empty()) {
    fs::copy_file(record.our_picture, scratch.path / kOurPicture, error);
    if (error) return cannot(scratch.path / kOurPicture, error);
    record.our_picture = folder / kOurPicture;
  }
  if (!record.povray_picture.empty()) {
    fs::copy_file(record.povray_picture, scratch.path / kPovrayPicture, error);
    if (error) return cannot(scratch.path / kPovrayPicture, error);
    record.povray_picture = folder / kPovrayPicture;
  }
  if (std::string why = write_text_file((scratch.path / kFile).string(), text_of(to_json(record))); !why.empty()) {
    return why;
  }
  return put_in_place(scratch.path, folder);
}

fs::path default_cache() {
  const char* const cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) return fs::path(cache) / "firstlight" / "compare";
  const char* const home = std::getenv("HOME");
  return fs::path(home != nullptr && *home != '\0' ? home : "/tmp") / ".cache" / "firstlight" / "compare";
}

}  // namespace firstlight::app::compare
