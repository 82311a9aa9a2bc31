#include "app/snapshots.h"

#include "app/picture_file.h"
#include "app/stats.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace firstlight::app {

Snapshots::Snapshots(std::string folder, const render::Film& film, const render::Settings& settings)
    : folder_(std::move(folder)), film_(film), settings_(settings) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) error_ = fmt::format("cannot make the folder '{}': {}", folder_, error.message());
}

void Snapshots::key_changed(const priority::Progress& progress) {
  take(fmt::format("key{:04}", progress.key), progress);
}

void Snapshots::finished(const priority::TraceStatistics& statistics) {
  priority::Progress progress;
  progress.seconds = statistics.seconds;
  progress.traced = statistics.rays;
  progress.remaining = statistics.remaining;
  progress.remaining_is_bound = statistics.remaining_is_bound;
  take("finished", progress);
}

void Snapshots::take(const std::string& occasion, const priority::Progress& progress) {
  if (!error_.empty()) return;
  Entry entry{fmt::format("snapshot-{:04}-{}.png", entries_.size() + 1, occasion), occasion, progress};
  error_ = write_film((std::filesystem::path(folder_) / entry.file).string(), film_, settings_,
                      {.numbers = {.alpha = film_.has_alpha()}});
  if (!error_.empty()) return;
  entries_.push_back(std::move(entry));
  write_index();
}

void Snapshots::write_index() {
  auto list = nlohmann::ordered_json::array();
  for (const Entry& entry : entries_) {
    const priority::Progress& progress = entry.progress;
    list.push_back({{"file", entry.file},
                    {"occasion", entry.occasion},
                    {"trace_s", progress.seconds},
                    {"key", progress.key < priority::kBuckets ? nlohmann::ordered_json(progress.key) : nullptr},
                    {"rays_traced", progress.traced.total()},
                    {"rays_waiting", progress.rays_waiting},
                    {"remaining", progress.remaining}});
  }
  error_ = write_text_file((std::filesystem::path(folder_) / "index.json").string(), list.dump(2) + "\n");
}

}  // namespace firstlight::app
