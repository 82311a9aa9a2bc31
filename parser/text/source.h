#pragma once

#include "parser/text/permissions.h"
#include "parser/text/token.h"
#include "render/scene/diagnostic.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::parser {

/// One file of scene text, as read.
/// Memory   Lives as long as the SourceFiles it came from; tokens hold views into `text`.
struct SourceFile {
  std::uint32_t index = 0;     ///< Location::file of its tokens
  std::string name;            ///< for messages
  std::filesystem::path path;  ///< canonical
  std::string text;
  std::vector<std::uint32_t> line_starts;  ///< byte offsets

  std::string line(std::uint32_t number) const;  ///< without its end; numbers count from 1
};

/// A message about a place in `file`.
render::Diagnostic diagnostic_at(const SourceFile& file, const Location& location,
                                 render::Diagnostic::Severity severity, std::string message);

/// Finds and reads the files a scene is made of, each once.
///
/// Order    A relative name is looked for in the current directory, the scene's folder, the including file's folder,
///          the library paths, the standard include folders [POV-Ray 3.7 asks the current directory first too].
/// Limits   Only regular files of at most kLargestFile bytes that the permissions allow: a scene is untrusted. A file
///          that is forbidden is not told from one that is not there.
class SourceFiles {
 public:
  static constexpr std::uintmax_t kLargestFile = std::uintmax_t{2} << 30;  // tokens and bytes have numbers of 32 bits

  enum class Status { found, missing, forbidden, too_large, unreadable };
  struct Result {
    Status status = Status::missing;
    const SourceFile* file = nullptr;  ///< of `found`, when it was read
    std::string path;                  ///< what was tried last, for messages
    bool other_case = false;           ///< found only by ignoring the case of letters
    bool other_slashes = false;        ///< found only by reading each '\\' as a '/'
  };

  /// Permissions of .conf files, each of which must allow a file. Without any the built-in ones hold, and a scene may
  /// read the folders that its files are looked for in.
  void restrict_to(std::vector<Permissions> permissions) { permissions_ = std::move(permissions); }
  /// The scene itself may lie anywhere.
  Result read_scene(const std::string& path, const std::vector<std::string>& library_paths);
  Result read_include(const std::string& name, const SourceFile& from);
  Result read_data(const std::string& name, const SourceFile& from);
  /// The path of a file that others read; it may lack one of the extensions.
  Result find_file(const std::string& name, const std::vector<std::string>& extensions, const SourceFile& from) const;
  /// The text of a regular file of bounded size; nothing when it cannot be read, which `why` tells more of.
  static std::optional<std::string> text_of(const std::filesystem::path& path, Status* why = nullptr);
  /// The canonical path of a file that may be written.
  Result place_for_writing(const std::string& name) const;
  /// Whether what is at that path may be replaced: nothing, what this program has made, or anything under permissions of
  /// .conf files. The scene itself never is, without them.
  bool may_replace(const std::filesystem::path& canonical) const;
  /// The standard include file, not read so far, that declares `name` at the beginning of a line; empty when none does.
  std::string standard_file_with(std::string_view name) const;
  /// The file at that path has changed: read it anew when it is asked for again.
  void forget(const std::filesystem::path& canonical);
  const SourceFile& file(std::uint32_t index) const { return *files_[index]; }

 private:
  struct Found {
    std::filesystem::path path;
    bool other_case = false;
    bool other_slashes = false;
    bool leads_out = false;  ///< the name leads out of all folders that may be read
  };
  Found find(const std::vector<std::string>& names, const SourceFile& from) const;
  bool may_reach(const std::filesystem::path& path) const;
  bool may_read(const std::filesystem::path& canonical) const;
  bool may_read_found(const std::filesystem::path& path) const;
  Result read_found(Result found);
  Result read(const std::filesystem::path& path, std::string name);

  std::vector<std::filesystem::path> folders_;  ///< searched in this order; the first is the current directory
  std::vector<Permissions> permissions_;
  bool is_built_in_ = false;  // the permissions are those that hold when nobody gives others
  std::vector<std::unique_ptr<SourceFile>> files_;
};

}  // namespace firstlight::parser
