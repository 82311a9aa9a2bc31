#pragma once

namespace firstlight::app {

/// Lets malloc use again what is freed instead of giving it back to the system: lists of objects that grow, and what
/// reading a scene leaves behind, would be fresh memory again and again, whose first touch takes a third of the time to
/// read a scene of many objects. Of lists up to 32 MiB; nothing where malloc is not glibc's.
/// Order    Before other threads begin.
void keep_freed_memory();

/// Gives back to the system what has been freed and kept.
void give_back_freed_memory();

}  // namespace firstlight::app
