#pragma once

#include "app/study/study.h"

#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app {

struct CsvFile {
  std::string name;
  std::string text;
};

/// The numbers behind a report: a file for each figure, one for the tables, one for the single rounds. A heading, then
/// a row for each moment of each scheme.
std::vector<CsvFile> csv_files(const Study& study);

/// In quotes when it holds a comma, a quote or a line's end.
std::string csv_field(std::string_view text);

}  // namespace firstlight::app
