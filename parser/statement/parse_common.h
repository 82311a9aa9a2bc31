#pragma once

#include "parser/directive/reader.h"
#include "render/feature/feature.h"
#include "render/math/transform.h"

#include <string>
#include <string_view>

namespace firstlight::parser {

/// Below this a length counts as nothing. [POV-Ray 3.7, EPSILON of its parser]
constexpr double kTinyLength = 1e-10;

/// The word between quotation marks.
std::string quoted(const Token& word);

/// That `feature` is asked for at `word`.
render::FeatureUse feature_use(render::Feature feature, const Token& word);

/// The version of the language in force where the reader stands, as 100 * version.
int language_version(Reader& reader);
/// The same, but a scene that never states its version counts as one written before 3.7.
int effective_language_version(Reader& reader);

/// Whether a colour begins here: a colour word, or the name of a colour. Numbers and vectors are none.
bool at_color(Reader& reader);
/// Where a colour is due but may be left out, which means black; that is a warning.
render::FilteredColor color_or_black(Reader& reader);

/// Fails at `at` unless `value` is finite; `what` names it in the message.
double finite(Reader& reader, const Token& at, double value, std::string_view what);
render::Vec3 finite(Reader& reader, const Token& at, const render::Vec3& value, std::string_view what);

bool is_finite(const render::Vec3& value);

/// A number, vector or integer that must be finite. An integer is cut towards zero and held between `low` and `high`.
double finite_number(Reader& reader, std::string_view what);
render::Vec3 finite_vector(Reader& reader, std::string_view what);
int integer(Reader& reader, std::string_view what, int low = -1'000'000'000, int high = 1'000'000'000);

/// Takes what stands between the next `{` and its `}`, whatever it is.
void skip_block(Reader& reader, const Token& owner);

}  // namespace firstlight::parser
