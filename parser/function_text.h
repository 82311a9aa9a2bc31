#pragma once

#include "render/function/program.h"

#include <span>
#include <string_view>

namespace firstlight::parser {

/// A program of an expression that stands by itself, outside of any scene, in the language of `function { }`; over the
/// parameters named. Never throws but std::bad_alloc.
render::CompileResult compile_text(std::string_view text, std::span<const std::string_view> parameters);

}  // namespace firstlight::parser
