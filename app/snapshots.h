#pragma once

#include "priority/driver.h"
#include "priority/observer.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace firstlight::app {

/// Writes intermediate pictures to a folder, with an index of when each was taken: the first whole picture, the one in
/// which every pixel has its first light, one whenever the key of the rays that leave the queue has changed (a few a
/// second at most), and the finished picture.
class Snapshots final : public priority::Observer {
 public:
  /// The folder is made when it is missing.
  Snapshots(std::string folder, const render::Film& film, const render::Settings& settings);

  void preview(const priority::Progress& progress) override { take("preview", progress); }
  void first_image(const priority::Progress& progress) override { take("first-image", progress); }
  void key_changed(const priority::Progress& progress) override;
  /// The picture after tracing.
  void finished(const priority::TraceStatistics& statistics);

  /// The first thing that went wrong; empty: nothing.
  const std::string& error() const { return error_; }

 private:
  void take(const std::string& occasion, const priority::Progress& progress);
  void write_index();

  struct Entry {
    std::string file;
    std::string occasion;
    priority::Progress progress;
  };

  const std::string folder_;
  const render::Film& film_;
  const render::Settings& settings_;
  std::vector<Entry> entries_;
  std::string error_;
};

}  // namespace firstlight::app
