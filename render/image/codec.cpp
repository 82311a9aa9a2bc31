#include "render/image/codec.h"

#include <dlfcn.h>
#include <fmt/format.h>

namespace firstlight::render {
namespace {

struct Opened {
  const ImageCodec* codec = nullptr;
  std::string error;
};

/// Found beside the program, by its run path. It stays open to the end: the library keeps threads and caches.
Opened open_module() {
  void* const library = ::dlopen(kImageCodecModule, RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library != nullptr ? ::dlsym(library, kImageCodecSymbol) : nullptr;
  if (symbol == nullptr) {
    const char* const why = ::dlerror();
    return {nullptr, fmt::format("the module for picture files cannot be opened: {}", why != nullptr ? why : "?")};
  }
  return {reinterpret_cast<const ImageCodec* (*)()>(symbol)(), {}};
}

}  // namespace

const ImageCodec* image_codec(std::string& error) {
  static const Opened opened = open_module();
  if (opened.codec == nullptr) error = opened.error;
  return opened.codec;
}

}  // namespace firstlight::render
