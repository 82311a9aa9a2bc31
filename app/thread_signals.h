#pragma once

namespace firstlight::app {

/// To be called by a thread that waits for users: signals from outside are for the main thread, and writing to one who
/// has gone is an error instead of a signal. Those that mean a fault of the thread itself stay open.
void block_signals();

}  // namespace firstlight::app
