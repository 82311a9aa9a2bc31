#pragma once

#include "priority/driver.h"

#include <cstddef>
#include <optional>
#include <string>

namespace firstlight::app {

/// The numbers that --stats writes.
/// Units  Times in seconds; preview, first_image and total from the start of the process.
struct Stats {
  std::string scene;
  std::string scheme;
  int threads = 0;
  int width = 0;
  int height = 0;
  double parse = 0.0;
  double build = 0.0;
  std::optional<double> preview;
  std::optional<double> first_image;
  double trace = 0.0;
  double total = 0.0;
  priority::End end = priority::End::complete;
  std::size_t queue_memory = 0;  ///< bytes that were allowed; 0: no limit
  priority::TraceStatistics rays;
};

std::string to_json(const Stats& stats);

/// Writes `text` beside the file and renames it, so the file is never half written, and a link stays one. Empty, or why it
/// failed.
std::string write_text_file(const std::string& name, const std::string& text);

}  // namespace firstlight::app
