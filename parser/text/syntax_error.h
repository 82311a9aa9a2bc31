#pragma once

#include "render/scene/diagnostic.h"

#include <cstdint>
#include <utility>

namespace firstlight::parser {

constexpr std::uint32_t kNoSymbol = 0xffffffff;

/// A mistake in the scene text: the error first, then its notes. Thrown inside the folder and caught between the
/// statements of a scene, where Recovery::recover() tells of it and goes on. Reader::fail and its kin make it.
struct SyntaxError {
  explicit SyntaxError(render::Diagnostics messages) : diagnostics(std::move(messages)) {}
  render::Diagnostics diagnostics;
  bool fatal = false;                    ///< reading cannot go on
  bool unbalanced = false;               ///< an end without a beginning: behind another mistake, its consequence
  std::uint32_t undeclared = kNoSymbol;  ///< the name that has no meaning, if that is the mistake
};

}  // namespace firstlight::parser
