#include "parser/statement/parse_shape.h"

#include "parser/statement/parse_common.h"
#include "render/shape/primitives.h"

#include <string>

namespace firstlight::parser {

using render::ShapePtr;
using render::Vec3;

namespace {

bool accept_open(Reader& reader) { return reader.accept(Keyword::open); }

void must_have_length(Reader& reader, const Token& word, const Vec3& a, const Vec3& b) {
  if ((a - b).length() >= kTinyLength) return;
  reader.fail(word, quoted(word) + " has no length: its two ends are the same point");
}

ShapePtr degenerate(Reader& reader, const Token& word) {
  reader.warn(word, quoted(word) + " is degenerate and is left out");
  return nullptr;
}

}  // namespace

ShapePtr parse_sphere(Reader& reader, const Token&) {
  const Vec3 center = finite_vector(reader, "center of 'sphere'");
  reader.skip_comma();
  return render::make_sphere(center, finite_number(reader, "radius of 'sphere'"));
}

ShapePtr parse_box(Reader& reader, const Token&) {
  const Vec3 corner1 = finite_vector(reader, "corner of 'box'");
  reader.skip_comma();
  return render::make_box(corner1, finite_vector(reader, "corner of 'box'"));
}

ShapePtr parse_plane(Reader& reader, const Token& word) {
  const Vec3 normal = finite_vector(reader, "normal of 'plane'");
  reader.skip_comma();
  if (normal.length() < kTinyLength) reader.fail(word, "normal of 'plane' has no length");
  return render::make_plane(normal, finite_number(reader, "distance of 'plane'"));
}

ShapePtr parse_cylinder(Reader& reader, const Token& word) {
  const Vec3 base = finite_vector(reader, "base of 'cylinder'");
  reader.skip_comma();
  const Vec3 cap = finite_vector(reader, "cap of 'cylinder'");
  reader.skip_comma();
  const double radius = finite_number(reader, "radius of 'cylinder'");
  const bool open = accept_open(reader);
  must_have_length(reader, word, base, cap);
  return render::make_cylinder(base, cap, radius, open);
}

ShapePtr parse_cone(Reader& reader, const Token& word) {
  const Vec3 base = finite_vector(reader, "base of 'cone'");
  reader.skip_comma();
  const double base_radius = finite_number(reader, "radius of 'cone'");
  reader.skip_comma();
  const Vec3 cap = finite_vector(reader, "cap of 'cone'");
  reader.skip_comma();
  const double cap_radius = finite_number(reader, "radius of 'cone'");
  const bool open = accept_open(reader);
  must_have_length(reader, word, base, cap);
  return render::make_cone(base, base_radius, cap, cap_radius, open);
}

ShapePtr parse_torus(Reader& reader, const Token&) {
  const double major = finite_number(reader, "radius of 'torus'");
  reader.skip_comma();
  return render::make_torus(major, finite_number(reader, "radius of 'torus'"));
}

ShapePtr parse_disc(Reader& reader, const Token& word) {
  const Vec3 center = finite_vector(reader, "center of 'disc'");
  reader.skip_comma();
  const Vec3 normal = finite_vector(reader, "normal of 'disc'");
  reader.skip_comma();
  const double radius = finite_number(reader, "radius of 'disc'");
  reader.skip_comma();
  double hole = 0.0;
  while (reader.at_number()) hole = finite_number(reader, "hole of 'disc'");
  if (normal.length() < kTinyLength) return degenerate(reader, word);
  return render::make_disc(center, normal, radius, hole);
}

ShapePtr parse_triangle(Reader& reader, const Token& word) {
  Vec3 corners[3];
  for (Vec3& corner : corners) {
    corner = finite_vector(reader, "corner of 'triangle'");
    if (&corner != &corners[2]) reader.skip_comma();
  }
  ShapePtr shape = render::make_triangle(corners[0], corners[1], corners[2]);
  return shape ? shape : degenerate(reader, word);
}

ShapePtr parse_smooth_triangle(Reader& reader, const Token& word) {
  Vec3 corners[3];
  Vec3 normals[3];
  for (int i = 0; i < 3; ++i) {
    corners[i] = finite_vector(reader, "corner of 'smooth_triangle'");
    reader.skip_comma();
    normals[i] = finite_vector(reader, "normal of 'smooth_triangle'");
    if (i < 2) reader.skip_comma();
  }
  for (const Vec3& normal : normals) {
    if (normal.length() == 0.0) return degenerate(reader, word);
  }
  ShapePtr shape = render::make_smooth_triangle(corners[0], normals[0], corners[1], normals[1], corners[2], normals[2]);
  return shape ? shape : degenerate(reader, word);
}

}  // namespace firstlight::parser
