#pragma once

#include "parser/directive/reader.h"
#include "render/texture/warp.h"

namespace firstlight::parser {

/// If the next word is `warp`, `turbulence`, `octaves`, `omega` or `lambda`: takes it with its argument.
bool accept_warp(Reader& reader, render::Warps& warps);

}  // namespace firstlight::parser
