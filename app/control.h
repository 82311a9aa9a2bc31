#pragma once

#include "app/desk.h"
#include "priority/steering.h"

namespace firstlight::app {

/// A way in which a user steers a picture: a socket, the keys of a terminal.
class Control {
 public:
  /// Nothing is asked of the picture any more. Those who wait for Desk::save_to() have to be let go before.
  virtual ~Control() = default;
  /// From now on the picture does what the user wants. `steering` and `desk` outlive this.
  virtual void start(priority::Steering& steering, Desk& desk) = 0;
};

}  // namespace firstlight::app
