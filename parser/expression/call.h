#pragma once

#include "parser/text/token.h"
#include "parser/text/value.h"
#include "render/function/spline.h"

#include <optional>

namespace firstlight::parser {

class Evaluator;

/// The kind of spline that a word names.
std::optional<render::SplineKind> spline_kind(const Token& word);

/// Whether the next token is the name of a function or spline, and a call of it follows.
bool at_call(Evaluator& in);
/// The value of that call. Pre: at_call().
Numbers parse_call(Evaluator& in);

}  // namespace firstlight::parser
