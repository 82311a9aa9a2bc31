#pragma once

#include "app/progress.h"
#include "priority/observer.h"
#include "priority/steering.h"

#include <utility>
#include <vector>

namespace firstlight::app {

/// All who want to know how far the picture is. They are told in their order.
class Audience final : public priority::Observer {
 public:
  explicit Audience(std::vector<priority::Observer*> members) : members_(std::move(members)) {}

  void progress(const priority::Progress& progress) override { tell(&Observer::progress, progress); }
  void key_changed(const priority::Progress& progress) override { tell(&Observer::key_changed, progress); }
  void preview(const priority::Progress& progress) override { tell(&Observer::preview, progress); }
  void first_image(const priority::Progress& progress) override { tell(&Observer::first_image, progress); }
  void save(const priority::Progress& progress) override { tell(&Observer::save, progress); }
  void checkpoint(const priority::Progress& progress) override { tell(&Observer::checkpoint, progress); }

 private:
  void tell(void (Observer::*what)(const priority::Progress&), const priority::Progress& progress) {
    for (Observer* const member : members_) (member->*what)(progress);
  }

  std::vector<priority::Observer*> members_;
};

/// The one who looks at the progress line.
class LineReader final : public priority::Observer {
 public:
  LineReader(ProgressLine& line, const priority::Steering& steering) : line_(line), steering_(steering) {}
  void progress(const priority::Progress& progress) override { line_.progress(progress, steering_.paused()); }

 private:
  ProgressLine& line_;
  const priority::Steering& steering_;
};

}  // namespace firstlight::app
