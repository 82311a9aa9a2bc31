#pragma once

#include "app/compare/record.h"
#include "app/compare/report/places.h"
#include "app/compare/report/report.h"

#include <string>
#include <vector>

namespace firstlight::app::compare {

/// The files of a scene in the report's folder.
struct SceneFiles {
  std::string stem;           ///< of letters, digits and hyphens: "0012-shapes-sphere"
  bool has_pictures = false;  ///< pictures/STEM-povray.png, -firstlight.png, -difference.png, -flip.png and small ones
  int width = 0;              ///< pixels, of both
  int height = 0;
  std::vector<Place> worst;

  std::string page() const { return "scenes/" + stem + ".html"; }
  std::string picture(const std::string& kind) const { return "pictures/" + stem + "-" + kind + ".png"; }
};

/// 1: "0001-shapes-sphere". Pre: number > 0.
std::string file_stem(std::size_t number, const std::string& name);

// Whole HTML documents. `files` has an element a record; `index` says which scene the page is of.

std::string index_page(const ReportContent& content, const std::vector<SceneFiles>& files);
std::string scene_page(const ReportContent& content, const std::vector<SceneFiles>& files, std::size_t index);

/// A report of ours is known by this, in its first lines.
inline constexpr std::string_view kReportMark = "<meta name=\"generator\" content=\"firstlight compare\">";

/// A document with the style sheet and a script of ours. `title` is plain text, `body` HTML.
std::string html_page(std::string_view title, std::string_view body, std::string_view script);

/// How bad it is, the worst is 0: what the rows are sorted by at first.
int badness(const SceneRecord& record);

}  // namespace firstlight::app::compare
