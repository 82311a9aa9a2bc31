#pragma once

#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/scene/object.h"

#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::parser {

/// How parse_object() reads a shape that says more of its object than its geometry: from behind the `{` to the first
/// modifier. Sets the object's shape or children, and what else the description implies. Neither set: there is nothing
/// to see, after a warning.
using RichReader = void (*)(Reader& reader, SceneContext& context, const Token& word, render::Object& object);

#define SHAPE(word, function)
#define PATCH(word, function)
#define RICH(word, function) \
  void function(Reader& reader, SceneContext& context, const Token& word_token, render::Object& object);
#include "parser/shapes.def"
#undef RICH
#undef PATCH
#undef SHAPE

/// Points that a scene may give one shape. Far more than curves are drawn with.
constexpr int kMostPoints = 1 << 20;

/// A number of points, which must be from `low` to kMostPoints; `what` names them in the message.
int point_count(Reader& reader, int low, std::string_view what);
/// `count` points in the plane, each behind a comma or not.
std::vector<render::Vec2> plane_points(Reader& reader, int count, const Token& word);

render::Vec2 finite_vector2(Reader& reader, std::string_view what);
render::Vec4 finite_vector4(Reader& reader, std::string_view what);

/// Whether two points are one as far as closing a curve goes.
bool same_point(const render::Vec2& a, const render::Vec2& b);
bool same_point(const render::Vec3& a, const render::Vec3& b);

}  // namespace firstlight::parser
