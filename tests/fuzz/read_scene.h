#pragma once

#include "parser/parser.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace firstlight::fuzz {

/// Reads the bytes of an input as a scene, from the file scene.pov in the working folder. Aborts unless the result is
/// either a scene or an error.
inline render::LoadResult read_scene(const std::uint8_t* data, std::size_t size, const render::LoadOptions& options) {
  constexpr const char* kScene = "scene.pov";
  std::FILE* const file = std::fopen(kScene, "wb");
  if (file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0) std::abort();
  render::LoadResult result = parser::PovFrontEnd().load(kScene, options);
  bool has_error = false;
  for (const auto& diagnostic : result.diagnostics) {
    has_error |= diagnostic.severity == render::Diagnostic::Severity::error;
  }
  if (has_error != (result.scene == nullptr)) std::abort();
  return result;
}

}  // namespace firstlight::fuzz
