#pragma once

#include "parser/reader.h"
#include "render/shape/shape.h"

namespace firstlight::parser {

/// How parse_object() reads the geometry of a shape: from behind the `{` to the first modifier. `word` is for messages.
/// Null: there is nothing to see (a degenerate triangle), after a warning.
using ShapeReader = render::ShapePtr (*)(Reader& reader, const Token& word);

#define SHAPE(word, function) render::ShapePtr function(Reader& reader, const Token& word_token);
#define PATCH(word, function) render::ShapePtr function(Reader& reader, const Token& word_token);
#define ABSENT_SHAPE(word)
#include "parser/shapes.def"
#undef ABSENT_SHAPE
#undef PATCH
#undef SHAPE

/// What stands for a shape that cannot be rendered, in declared objects that may never be used. It holds the word and its
/// place, so that using it can name both.
class AbsentShape final : public render::Shape {
 public:
  explicit AbsentShape(const Token& word) : word_(word) {}
  const Token& word() const { return word_; }

  void crossings(const render::Ray&, std::vector<render::Crossing>&) const override {}
  bool inside(const render::Vec3&) const override { return false; }
  render::Vec3 normal(const render::Vec3&, const render::Crossing&) const override { return {0.0, 0.0, 0.0}; }
  render::Box3 bounds() const override { return {}; }
  render::ShapePtr placed(const render::Transform&) const override { return std::make_shared<AbsentShape>(word_); }
  render::ShapePtr inverted() const override { return std::make_shared<AbsentShape>(word_); }

 private:
  Token word_;
};

}  // namespace firstlight::parser
