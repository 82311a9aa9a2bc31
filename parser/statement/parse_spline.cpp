#include "parser/directive/interpreter.h"
#include "parser/expression/call.h"
#include "parser/expression/expression.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_function.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace firstlight::parser {

using render::Spline;
using render::SplineKind;

std::shared_ptr<const Spline> parse_spline(Reader& reader, const Token& word) {
  reader.open_block(word);
  std::vector<Spline::Point> points;
  std::size_t components = 2;
  SplineKind kind = SplineKind::linear;
  if (const auto declared = reader.accept_declared<Spline>()) {
    points = declared->points();
    components = declared->components();
    kind = declared->kind();
  }
  while (const auto next = spline_kind(reader.peek())) {
    kind = *next;
    reader.take();
  }
  while (reader.at_number()) {
    Spline::Point point;
    if (points.size() == Spline::kMostPoints) reader.fail(word, "the spline has too many points");
    point.at = finite_number(reader, "the parameter of a spline's point");
    reader.skip_comma();
    const Numbers value = parse_sum(reader.interpreter(), 2);
    point.values = value.values;
    components = std::max<std::size_t>(components, value.size);
    reader.skip_comma();
    points.push_back(point);
  }
  if (points.empty()) reader.fail(word, "a spline needs at least one point");
  reader.close_block();
  return std::make_shared<const Spline>(kind, std::move(points), components);
}

}  // namespace firstlight::parser
