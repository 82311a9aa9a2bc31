#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

/// The bytes of a file; empty when it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

/// A number for what it was given; parts that are given one after the other are kept apart.
/// Source  FNV-1a of 64 bits: Fowler, Noll, Vo.
class Digest {
 public:
  Digest& add(std::string_view bytes);
  Digest& add(std::int64_t number) { return add(std::to_string(number)); }
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Digests of what scenes are made of: two that are equal stand for scenes that render alike.
/// Threads  Any.
class SceneContent {
 public:
  /// `libraries`: folders that included files and images are looked for in, beside the scene's own.
  explicit SceneContent(std::span<const std::filesystem::path> libraries)
      : libraries_(libraries.begin(), libraries.end()) {}

  /// The digest of the scene, of every file whose name stands between quotes in it or in such a file, and, because
  /// names can be put together, of every other file beside the scene but for scenes.
  std::string of(const std::filesystem::path& scene);
  /// Whether the scene, or a file whose name stands between quotes in it or in such a file, opens files to write into.
  bool writes_files(const std::filesystem::path& scene);
  /// The digest of one file; that of nothing when it cannot be read.
  std::string of_file(const std::filesystem::path& file);

 private:
  struct File {
    std::string digest;
    std::vector<std::string> names;  ///< between quotes
    bool writes = false;             ///< it opens files to write into
  };
  using Files = std::map<std::filesystem::path, File>;  // in an order that does not depend on the way

  File look_at(const std::filesystem::path& file);
  /// `waiting` and what is named in them. `folder`: the scene's.
  Files follow(const std::filesystem::path& folder, std::vector<std::filesystem::path> waiting);

  std::vector<std::filesystem::path> libraries_;
  std::mutex mutex_;
  Files known_;
};

}  // namespace firstlight::app::compare
