#include "render/math/zeroed_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <limits>
#include <new>

namespace firstlight::render {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20;  // of x86-64 and of most ARM systems
/// Systems have some huge pages at hand. Of a virtual machine the host has to find them first, if they are many, and takes
/// several times as long for them as for small ones.
constexpr std::size_t kMostInHugePages = 64 * kHugePage;

}  // namespace

ZeroedMemory::ZeroedMemory(std::size_t bytes) {
  if (bytes == 0) return;
  if (bytes > std::numeric_limits<std::size_t>::max() - kHugePage) throw std::bad_alloc();
  // Only whole huge pages, and only those that begin where one can, are ever made of it.
  const bool is_large = bytes >= kHugePage;
  mapped_bytes_ = is_large ? bytes + kHugePage : bytes;
  mapped_ = mmap(nullptr, mapped_bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped_ == MAP_FAILED) {
    mapped_ = nullptr;
    throw std::bad_alloc();
  }
  data_ = mapped_;
  if (!is_large) return;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(mapped_);
  const std::size_t gap = (kHugePage - address % kHugePage) % kHugePage;
  data_ = static_cast<char*>(mapped_) + gap;
  // Only a wish. What is left over at the end is not worth a whole one.
  if (bytes <= kMostInHugePages) madvise(data_, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
}

void ZeroedMemory::touch(std::size_t bytes) {
#ifdef MADV_POPULATE_WRITE
  // Only a wish, of Linux 5.14 and later.
  if (bytes != 0) madvise(data_, bytes, MADV_POPULATE_WRITE);
#else
  static_cast<void>(bytes);
#endif
}

ZeroedMemory::~ZeroedMemory() {
  if (mapped_ != nullptr) munmap(mapped_, mapped_bytes_);
}

}  // namespace firstlight::render
