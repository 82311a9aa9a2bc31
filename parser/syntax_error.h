#pragma once

#include "render/scene/diagnostic.h"

#include <utility>

namespace firstlight::parser {

/// A mistake in the scene text: the error first, then its notes. Thrown inside the folder, caught by PovFrontEnd::load.
/// The first one ends the parse. Reader::fail and its kin make it.
struct SyntaxError {
  explicit SyntaxError(render::Diagnostics messages) : diagnostics(std::move(messages)) {}
  render::Diagnostics diagnostics;
};

}  // namespace firstlight::parser
