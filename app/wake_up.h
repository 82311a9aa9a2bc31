#pragma once

#include "app/descriptor.h"

namespace firstlight::app {

/// Ends another thread's poll().
class WakeUp {
 public:
  /// Throws std::system_error when the system has no descriptor left.
  WakeUp();

  /// Becomes readable when ring() is called, and stays so.
  int readable() const { return event_.get(); }
  void ring();

 private:
  Descriptor event_;
};

}  // namespace firstlight::app
