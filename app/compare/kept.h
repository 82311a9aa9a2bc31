#pragma once

#include "app/compare/record.h"
#include "app/compare/settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace firstlight::app::compare {

/// Results of comparisons that are kept in a folder, each in a folder of its own that is made beside and renamed, so
/// that what is there is whole.
/// Threads  Any; and several processes.
class KeptResults {
 public:
  explicit KeptResults(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the folder where it is missing. Empty, or what is wrong.
  std::string prepare() const;

  /// POV-Ray's part; its picture lies in the folder. Nothing when there is none or it cannot be read.
  std::optional<Rendered> povray(const std::string& key) const;
  std::optional<SceneRecord> record(const std::string& key) const;

  /// An empty folder for a comparison's pictures. Empty, or what is wrong.
  std::string make_scratch(std::filesystem::path& scratch) const;
  /// Copies what POV-Ray made. Empty, or what is wrong.
  std::string keep_povray(const std::string& key, const Rendered& povray) const;
  /// Copies its pictures; the record then tells where the copies are. Empty, or what is wrong.
  std::string keep_record(const std::string& key, SceneRecord& record) const;

 private:
  std::filesystem::path folder_of_povray(const std::string& key) const { return folder_ / ("povray-" + key); }
  std::filesystem::path folder_of_record(const std::string& key) const { return folder_ / ("scene-" + key); }

  std::filesystem::path folder_;
};

/// `firstlight` in the user's cache folder. Source: XDG Base Directory Specification.
std::filesystem::path default_cache();

}  // namespace firstlight::app::compare
