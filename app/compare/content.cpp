#include "app/compare/content.h"

#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

// Larger files are known by their size and time alone.
constexpr std::uintmax_t kLargestRead = std::uintmax_t{1} << 26;
constexpr std::size_t kLongestName = 512;  // of a file

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Whether the file can name others: what POV-Ray includes may have any extension, but a picture is no text.
bool is_text(std::string_view bytes) { return bytes.find('\0') == std::string_view::npos; }

std::vector<std::string> quoted_names(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t at = text.find('"'); at != std::string_view::npos; at = text.find('"', at)) {
    const std::size_t end = text.find_first_of("\"\n", at + 1);
    if (end == std::string_view::npos) break;
    const std::string_view name = text.substr(at + 1, end - at - 1);
    // Behind an odd quote, as in a comment, a closing one looks like an opening one: it is tried again as such.
    if (!name.empty() && name.size() <= kLongestName) found.emplace(name);
    at = text[end] == '"' ? end : end + 1;
  }
  return {found.begin(), found.end()};
}

/// Whether a line has `#fopen Name "file" write`, or `append`.
bool opens_to_write(std::string_view text) {
  constexpr std::string_view kOpen = "fopen";
  for (std::size_t at = text.find(kOpen); at != std::string_view::npos; at = text.find(kOpen, at + 1)) {
    const std::size_t before = text.substr(0, at).find_last_not_of(" \t");
    if (before == std::string_view::npos || text[before] != '#') continue;
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    if (line.find("write") != std::string_view::npos || line.find("append") != std::string_view::npos) return true;
  }
  return false;
}

}  // namespace

std::string read_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Digest& Digest::add(std::string_view bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3u;
  for (const char c : bytes) state_ = (state_ ^ static_cast<unsigned char>(c)) * kPrime;
  // The length, so that "ab" and "c" are not "a" and "bc".
  for (std::uint64_t length = bytes.size(), i = 0; i < 8; ++i, length >>= 8)
    state_ = (state_ ^ (length & 255u)) * kPrime;
  return *this;
}

std::string Digest::text() const { return fmt::format("{:016x}", state_); }

SceneContent::File SceneContent::look_at(const fs::path& file) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(file); found != known_.end()) return found->second;
  }
  File result;
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size > kLargestRead) {
    const auto time = fs::last_write_time(file, error).time_since_epoch().count();
    result.digest = Digest().add(static_cast<std::int64_t>(size)).add(static_cast<std::int64_t>(time)).text();
  } else {
    const std::string bytes = read_bytes(file);
    result.digest = Digest().add(bytes).text();
    if (is_text(bytes)) {
      result.names = quoted_names(bytes);
      result.writes = opens_to_write(bytes);
    }
  }
  const std::lock_guard lock(mutex_);
  return known_.emplace(file, std::move(result)).first->second;
}

std::string SceneContent::of_file(const fs::path& file) { return look_at(file).digest; }

SceneContent::Files SceneContent::follow(const fs::path& folder, std::vector<fs::path> waiting) {
  Files read;
  const auto want = [&](const fs::path& file) {
    if (is_file(file)) waiting.push_back(file.lexically_normal());
  };
  while (!waiting.empty()) {
    const fs::path file = std::move(waiting.back());
    waiting.pop_back();
    if (read.contains(file)) continue;
    const File seen = look_at(file);
    read.emplace(file, seen);
    for (const std::string& name : seen.names) {
      want(folder / name);
      want(file.parent_path() / name);
      for (const fs::path& library : libraries_) want(library / name);
    }
  }
  return read;
}

bool SceneContent::writes_files(const fs::path& scene) {
  const Files files = follow(scene.parent_path(), {scene});
  return std::any_of(files.begin(), files.end(), [](const auto& file) { return file.second.writes; });
}

std::string SceneContent::of(const fs::path& scene) {
  const fs::path folder = scene.parent_path();
  std::vector<fs::path> beside{scene};
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const fs::path& file = at->path();
    if (lower(file.extension().string()) != ".pov" && is_file(file)) beside.push_back(file.lexically_normal());
  }
  Digest digest;
  for (const auto& [file, seen] : follow(folder, std::move(beside))) {
    digest.add(file.lexically_relative(folder).generic_string()).add(seen.digest);
  }
  return digest.text();
}

}  // namespace firstlight::app::compare
