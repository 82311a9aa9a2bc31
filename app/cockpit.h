#pragma once

#include "app/control.h"
#include "app/desk.h"
#include "priority/steering.h"

#include <memory>
#include <utility>
#include <vector>

namespace firstlight::app {

/// The ways in which a picture is steered, while one of these lives.
class Cockpit {
 public:
  Cockpit(priority::Steering& steering, Desk& desk, std::vector<std::unique_ptr<Control>> controls)
      : desk_(desk), controls_(std::move(controls)) {
    for (const auto& control : controls_) control->start(steering, desk);
  }
  Cockpit(const Cockpit&) = delete;
  Cockpit& operator=(const Cockpit&) = delete;
  /// Nobody is left waiting for a picture: the threads could not end.
  ~Cockpit() { desk_.close(); }

 private:
  Desk& desk_;
  std::vector<std::unique_ptr<Control>> controls_;
};

}  // namespace firstlight::app
