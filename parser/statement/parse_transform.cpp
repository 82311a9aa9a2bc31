#include "parser/statement/parse_transform.h"

#include "parser/statement/parse_common.h"

#include <fmt/format.h>

#include <cmath>

namespace firstlight::parser {
namespace {

using render::Mat4;
using render::Transform;
using render::Vec3;

Transform parse_scale(Reader& reader) {
  const Token& at = reader.peek();
  Vec3 factors = finite(reader, at, reader.vector3(), "scale");
  for (int axis = 0; axis < 3; ++axis) {
    if (factors[axis] != 0.0) continue;
    reader.warn(at, "scale by 0 along " + std::string(1, "xyz"[axis]) + " is taken as 1");
    factors[axis] = 1.0;
  }
  return Transform::scaling(factors);
}

/// `<` twelve numbers `>`: four rows of three; the fourth moves.
Transform parse_matrix(Reader& reader) {
  const Token& at = reader.peek();
  if (!reader.accept(Punctuation::less)) reader.fail_expected("'<' and twelve numbers");
  Mat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      if (row + column > 0) reader.skip_comma();
      matrix[row][column] = finite_number(reader, "matrix");
    }
  }
  if (!reader.accept(Punctuation::greater)) reader.fail_expected("'>' after twelve numbers");
  for (int column = 0; column < 3; ++column) {
    if (std::abs(matrix[0][column]) < kTinyLength && std::abs(matrix[1][column]) < kTinyLength &&
        std::abs(matrix[2][column]) < kTinyLength) {
      reader.warn(at, fmt::format("matrix leaves nothing of {}; its diagonal is taken as 1", "xyz"[column]));
      matrix[column][column] = 1.0;
    }
  }
  if (!Transform::is_invertible(matrix)) reader.fail(at, "matrix cannot be inverted");
  return Transform(matrix);
}

}  // namespace

std::optional<Transform> accept_transformation(Reader& reader) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return std::nullopt;
  switch (next.keyword) {
    case Keyword::translate:
      reader.take();
      return Transform::translation(finite_vector(reader, "translate"));
    case Keyword::rotate:
      reader.take();
      return Transform::rotation(finite_vector(reader, "rotate"));
    case Keyword::scale:
      reader.take();
      return parse_scale(reader);
    case Keyword::matrix:
      reader.take();
      return parse_matrix(reader);
    case Keyword::transform: {
      const Token& word = reader.take();
      return parse_transform(reader, word);
    }
    default:
      return std::nullopt;
  }
}

Transform parse_transform(Reader& reader, const Token& word) {
  if (const auto declared = reader.accept_declared<Transform>()) return *declared;
  Transform result;
  bool inverted = false;
  reader.open_block(word);
  for (;;) {
    if (reader.accept(Keyword::inverse)) {
      inverted = true;
    } else if (const auto declared = reader.accept_declared<Transform>()) {
      result = result.then(*declared);
    } else if (const auto next = accept_transformation(reader)) {
      result = result.then(*next);
    } else {
      break;
    }
  }
  reader.close_block();
  return inverted ? result.inverse() : result;
}

}  // namespace firstlight::parser
