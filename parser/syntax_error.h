#pragma once

#include "render/scene/diagnostic.h"

#include <utility>

namespace firstlight::parser {

/// A mistake in the scene text: the error first, then its notes. Thrown inside the folder, caught by PovFrontEnd::load.
/// The first one ends the parse. Reader::fail and its kin make it.
struct SyntaxError {
  explicit SyntaxError(render::Diagnostics messages, bool is_unsupported = false)
      : diagnostics(std::move(messages)), unsupported(is_unsupported) {}
  render::Diagnostics diagnostics;
  /// Correct, but not supported; a value that is only declared may be so.
  bool unsupported = false;
};

}  // namespace firstlight::parser
