#include "app/thread_signals.h"

#include <pthread.h>
#include <signal.h>

#include <initializer_list>

namespace firstlight::app {

void block_signals() {
  sigset_t blocked;
  sigfillset(&blocked);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigdelset(&blocked, fault);
  pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
}

}  // namespace firstlight::app
