#include "parser/statement/parse_form.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/expression.h"
#include "parser/statement/parse_common.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace firstlight::parser {

using render::Vec2;
using render::Vec3;
using render::Vec4;

int point_count(Reader& reader, int low, std::string_view what) {
  const Token& at = reader.peek();
  const int count = integer(reader, what);
  if (count < low) reader.fail(at, fmt::format("expected at least {} {}, found {}", low, what, count));
  if (count > kMostPoints) reader.fail(at, fmt::format("expected at most {} {}, found {}", kMostPoints, what, count));
  return count;
}

std::vector<Vec2> plane_points(Reader& reader, int count, const Token& word) {
  std::vector<Vec2> points;
  const std::string what = "point of " + quoted(word);
  for (int i = 0; i < count; ++i) {
    reader.skip_comma();
    points.push_back(finite_vector2(reader, what));
  }
  return points;
}

Vec2 finite_vector2(Reader& reader, std::string_view what) {
  const Token& at = reader.peek();
  const Vec2 value = reader.vector2();
  finite(reader, at, Vec3(value.x, value.y, 0.0), what);
  return value;
}

Vec4 finite_vector4(Reader& reader, std::string_view what) {
  const Token& at = reader.peek();
  const Numbers numbers = parse_sum(reader.interpreter(), 4);
  if (numbers.size > 4) {
    reader.fail(at, "expected a 4D vector, found a " + std::string(kind_name(numbers)) + " expression");
  }
  const auto& values = numbers.values;
  finite(reader, at, Vec3(values[0], values[1], values[2]), what);
  finite(reader, at, values[3], what);
  return {values[0], values[1], values[2], values[3]};
}

bool same_point(const Vec2& a, const Vec2& b) {
  return std::abs(a.x - b.x) < kTinyLength && std::abs(a.y - b.y) < kTinyLength;
}

bool same_point(const Vec3& a, const Vec3& b) {
  return std::abs(a.x - b.x) < kTinyLength && std::abs(a.y - b.y) < kTinyLength && std::abs(a.z - b.z) < kTinyLength;
}

}  // namespace firstlight::parser
