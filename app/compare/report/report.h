#pragma once

#include "app/compare/record.h"

#include <filesystem>
#include <span>
#include <string>

namespace firstlight::app::compare {

/// The subjects of a report.
struct ReportContent {
  std::span<const SceneRecord> records;
  std::string title;    ///< of the folder or list
  std::string command;  ///< that made it
};

/// Whether a report can be put there: nothing is there yet, or an empty folder, or a report of before. Empty, or what
/// is wrong.
std::string check_report_folder(const std::filesystem::path& folder);

/// Writes the folder anew: `index.html`, a page a scene, the pictures. It needs nothing from outside and works when it
/// is opened from the disk. It is made beside and renamed when it is whole. Empty, or what is wrong.
std::string write_report(const std::filesystem::path& folder, const ReportContent& content);

}  // namespace firstlight::app::compare
