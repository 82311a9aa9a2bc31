#pragma once

#include "app/desk.h"
#include "app/progress.h"
#include "app/snapshots.h"
#include "priority/observer.h"
#include "priority/steering.h"

#include <utility>

namespace firstlight::app {

/// All who want to know how far the picture is: the progress line, those who steer, and the snapshots, if there are
/// any.
class Audience final : public priority::Observer {
 public:
  /// `write`: of the pictures that those who steer want to have saved.
  Audience(ProgressLine& line, const priority::Steering& steering, Desk& desk, Desk::Write write)
      : line_(line), steering_(steering), desk_(desk), write_(std::move(write)) {}

  /// Takes snapshots from now on.
  void take_snapshots(Snapshots& snapshots) { snapshots_ = &snapshots; }

  void progress(const priority::Progress& progress) override {
    desk_.publish(progress);
    line_.progress(progress, steering_.paused());
  }
  void key_changed(const priority::Progress& progress) override {
    if (snapshots_ != nullptr) snapshots_->key_changed(progress);
  }
  void preview(const priority::Progress& progress) override {
    if (snapshots_ != nullptr) snapshots_->preview(progress);
  }
  void first_image(const priority::Progress& progress) override {
    if (snapshots_ != nullptr) snapshots_->first_image(progress);
  }
  void save(const priority::Progress& progress) override {
    desk_.publish(progress);
    desk_.serve(write_);
  }

 private:
  ProgressLine& line_;
  const priority::Steering& steering_;
  Desk& desk_;
  Desk::Write write_;
  Snapshots* snapshots_ = nullptr;
};

}  // namespace firstlight::app
