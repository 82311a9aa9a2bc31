#include "app/heap.h"

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#endif

namespace firstlight::app {

#ifdef __GLIBC__

void use_large_pages() {
  constexpr int kMegabyte = 1 << 20;
  constexpr int kReserved = 512 * kMegabyte;
  constexpr std::uintptr_t kLargePage = 2 * kMegabyte;
  // Lists of objects that grow belong there too. That is as far as malloc would raise this threshold by itself.
  if (mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte) == 0) return;
  // The heap always ends in what has not been used yet; it must not be given back for that.
  mallopt(M_TRIM_THRESHOLD, kReserved + 64 * kMegabyte);
  // Asked for more than it has, malloc extends the heap, by so much more. A system that refuses refuses all of it.
  mallopt(M_TOP_PAD, kReserved);
  void* const asked = std::malloc(kMegabyte);
  mallopt(M_TOP_PAD, kMegabyte);
  if (asked == nullptr) return;
  const auto begin = (reinterpret_cast<std::uintptr_t>(asked) + kLargePage - 1) / kLargePage * kLargePage;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / kLargePage * kLargePage;
  std::free(asked);
  // Unless malloc went elsewhere, the heap now reaches beyond.
  if (begin < end && end - begin <= kReserved + kLargePage) {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
}

#else

void use_large_pages() {}

#endif

}  // namespace firstlight::app
