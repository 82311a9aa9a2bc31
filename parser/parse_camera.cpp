#include "parser/parse_camera.h"

#include "parser/parse_common.h"
#include "parser/parse_transform.h"

#include <algorithm>
#include <cmath>

namespace firstlight::parser {

using render::Camera;
using render::Transform;
using render::Vec3;

namespace {

/// The words of a camera under way.
struct Draft {
  Camera camera;
  std::optional<double> angle;
  std::optional<Vec3> look_at;
  Token look_at_word;
  Transform transform;
  Token aperture_word;
  double aperture = 0.0;
  double blur_samples = 0.0;
};

double parse_angle(Reader& reader) {
  const Token at = reader.peek();
  const double angle = finite_number(reader, "angle");
  if (angle < 0.0) reader.fail(at, "'angle' cannot be negative");
  if (angle >= 180.0) reader.fail(at, "'angle' must be below 180 degrees");
  return angle;
}

void apply_angle(Camera& camera, double angle) {
  if (angle > 0.0) render::set_angle(camera, angle);
}

void apply_look_at(Reader& reader, const Token& word, Camera& camera, const Vec3& target) {
  const Vec3 way = target - camera.location;
  if (way.length2() < kTinyLength) reader.fail(word, "'look_at' and 'location' of a camera must be different points");
  const Vec3 sideways = camera.sky.cross(way / way.length());
  if (std::max({std::abs(sideways.x), std::abs(sideways.y), std::abs(sideways.z)}) < kTinyLength) {
    reader.warn(word, "the camera looks along its 'sky' vector; 'right' decides which way is up");
  }
  render::look_at(camera, target);
}

/// Blurred depth, which takes both an aperture and samples. It is refused when the whole camera is known.
bool accept_blur(Reader& reader, Draft& draft) {
  if (reader.next_is(Keyword::aperture)) {
    draft.aperture_word = reader.take();
    draft.aperture = reader.number();
  } else if (reader.accept(Keyword::blur_samples)) {
    const Token at = reader.peek();
    draft.blur_samples = reader.number();
    if (!(draft.blur_samples > 0.0)) reader.fail(at, "'blur_samples' must be above 0");
    reader.skip_comma();
    reader.optional_number(0.0);
  } else if (reader.accept(Keyword::focal_point)) {
    reader.vector3();
  } else if (reader.accept(Keyword::confidence) || reader.accept(Keyword::variance)) {
    reader.number();
  } else {
    return false;
  }
  return true;
}

void refuse_blur(Reader& reader, const Draft& draft) {
  if (draft.aperture != 0.0 && draft.blur_samples > 0.0) fail_unsupported(reader, draft.aperture_word);
}

/// Vectors of the camera. False: the next word is none of them.
bool accept_vector(Reader& reader, Camera& camera) {
  if (reader.accept(Keyword::location)) {
    camera.location = finite_vector(reader, "location");
  } else if (reader.accept(Keyword::direction)) {
    camera.direction = finite_vector(reader, "direction");
  } else if (reader.accept(Keyword::up)) {
    camera.up = finite_vector(reader, "up");
  } else if (reader.accept(Keyword::right)) {
    camera.right = finite_vector(reader, "right");
  } else if (reader.accept(Keyword::sky)) {
    camera.sky = finite_vector(reader, "sky");
  } else {
    return false;
  }
  return true;
}

void refuse_other_cameras(Reader& reader) {
  const Token& next = reader.peek();
  if (next.kind != TokenKind::keyword) return;
  switch (next.keyword) {
    case Keyword::bokeh:
    case Keyword::cylinder:
    case Keyword::fisheye:
    case Keyword::mesh_camera:
    case Keyword::normal:
    case Keyword::omnimax:
    case Keyword::orthographic:
    case Keyword::panoramic:
    case Keyword::spherical:
    case Keyword::ultra_wide_angle:
      fail_unsupported(reader, reader.take());
    default:
      return;
  }
}

/// From version 3.5 on the order of the words does not matter: lengths first, then the angle (which needs `right`),
/// then where to look, then the transformations.
void parse_unordered(Reader& reader, Draft& draft) {
  while (reader.accept(Keyword::perspective)) {
  }
  for (;;) {
    if (reader.accept(Keyword::angle)) {
      draft.angle = parse_angle(reader);
    } else if (reader.next_is(Keyword::look_at)) {
      draft.look_at_word = reader.take();
      draft.look_at = finite_vector(reader, "look_at");
    } else if (const auto transform = accept_transformation(reader)) {
      draft.transform = draft.transform.then(*transform);
    } else if (!accept_vector(reader, draft.camera) && !accept_blur(reader, draft)) {
      break;
    }
  }
  refuse_other_cameras(reader);
  if (draft.angle) apply_angle(draft.camera, *draft.angle);
  if (draft.look_at) apply_look_at(reader, draft.look_at_word, draft.camera, *draft.look_at);
  render::place(draft.camera, draft.transform);
}

/// Before version 3.5 every word takes effect where it stands.
void parse_in_order(Reader& reader, Draft& draft) {
  for (;;) {
    if (reader.accept(Keyword::perspective)) continue;
    if (reader.accept(Keyword::angle)) {
      apply_angle(draft.camera, parse_angle(reader));
    } else if (reader.next_is(Keyword::look_at)) {
      const Token word = reader.take();
      apply_look_at(reader, word, draft.camera, finite_vector(reader, "look_at"));
    } else if (const auto transform = accept_transformation(reader)) {
      render::place(draft.camera, *transform);
    } else if (!accept_vector(reader, draft.camera) && !accept_blur(reader, draft)) {
      break;
    }
  }
  refuse_other_cameras(reader);
}

void warn_if_skewed(Reader& reader, const Token& word, const Camera& camera) {
  const double skew = std::max({std::abs(camera.right.dot(camera.up)), std::abs(camera.right.dot(camera.direction)),
                                std::abs(camera.up.dot(camera.direction))});
  if (skew > kTinyLength)
    reader.warn(word, "the vectors of the camera are not at right angles; 'look_at' as the last word may help");
}

}  // namespace

Camera parse_camera(Reader& reader, const Token& word, const Camera& start) {
  reader.open_block(word);
  Draft draft;
  draft.camera = start;
  const auto declared = reader.accept_declared<Camera>();
  if (declared) draft.camera = *declared;
  if (language_version(reader) < 350) {
    parse_in_order(reader, draft);
  } else if (declared) {
    // a declared camera can only be moved
    while (const auto transform = accept_transformation(reader)) render::place(draft.camera, *transform);
  } else {
    parse_unordered(reader, draft);
  }
  refuse_blur(reader, draft);
  reader.close_block();
  warn_if_skewed(reader, word, draft.camera);
  return draft.camera;
}

}  // namespace firstlight::parser
