#include "parser/statement/parse_camera.h"

#include "parser/statement/parse_camera_kind.h"
#include "parser/statement/parse_common.h"
#include "parser/statement/parse_surface.h"
#include "parser/statement/parse_transform.h"
#include "render/camera/lens_grid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace firstlight::parser {

using render::Camera;
using render::CameraKind;
using render::Transform;
using render::Vec3;

namespace {

/// The words of a camera under way.
struct Draft {
  Camera camera;
  std::optional<double> angle;
  std::optional<Vec3> look_at, focal_point;
  bool up_given = false, right_given = false;
  Token kind_word, look_at_word, aperture_word, normal_word;
  Transform transform;
  double direction_length = 1.0;  ///< after the last word that sets it
};

bool is_flat(CameraKind kind) { return kind == CameraKind::perspective || kind == CameraKind::orthographic; }

/// Parses what follows `angle`.
void parse_angle(Reader& reader, Draft& draft) {
  const Token& at = reader.peek();
  Camera& camera = draft.camera;
  if (camera.kind == CameraKind::spherical) {
    camera.horizontal_angle = finite_number(reader, "angle");
    reader.skip_comma();
    camera.vertical_angle = finite(reader, at, reader.optional_number(camera.horizontal_angle * 0.5), "angle");
    if (camera.horizontal_angle < 0.0 || camera.vertical_angle < 0.0) reader.fail(at, "'angle' cannot be negative");
    return;
  }
  const bool may_be_left_out = camera.kind == CameraKind::orthographic;
  const double angle = finite(reader, at, may_be_left_out ? reader.optional_number(0.0) : reader.number(), "angle");
  if (angle < 0.0) reader.fail(at, "'angle' cannot be negative");
  if (angle >= 180.0 && is_flat(camera.kind)) reader.fail(at, "'angle' must be below 180 degrees");
  draft.angle = angle;
}

void apply_angle(Draft& draft) {
  Camera& camera = draft.camera;
  camera.angle = *draft.angle;
  if (!is_flat(camera.kind) || camera.angle <= 0.0) return;
  render::set_angle(camera, camera.angle);
  draft.direction_length = camera.direction.length();
}

void apply_look_at(Reader& reader, Draft& draft) {
  Camera& camera = draft.camera;
  camera.look_at = *draft.look_at;
  const Vec3 way = camera.look_at - camera.location;
  if (way.length2() < kTinyLength) {
    reader.fail(draft.look_at_word, "'look_at' and 'location' of a camera must be different points");
  }
  const Vec3 sideways = camera.sky.cross(way / way.length());
  if (std::max({std::abs(sideways.x), std::abs(sideways.y), std::abs(sideways.z)}) < kTinyLength) {
    reader.warn(draft.look_at_word, "the camera looks along its 'sky' vector; 'right' decides which way is up");
  }
  draft.direction_length = camera.direction.length();
  render::look_at(camera, camera.look_at);
}

void apply_focal_point(Draft& draft) {
  Camera& camera = draft.camera;
  camera.blur.focal_point = *draft.focal_point;
  camera.blur.focal_distance = (camera.blur.focal_point - camera.location).length();
}

/// A number strictly between 0 and 1; the ends count where `closed`. Anything else is a warning and changes nothing.
void parse_share(Reader& reader, const Token& word, bool closed, double& share) {
  const double value = reader.number();
  if (closed ? value >= 0.0 && value <= 1.0 : value > 0.0 && value < 1.0) {
    share = value;
  } else {
    reader.warn(word, quoted(word) + " must be from 0 to 1; this one is ignored");
  }
}

void parse_blur_samples(Reader& reader, render::FocalBlur& blur) {
  const Token& at = reader.peek();
  const auto check_most = [&](int samples) {
    if (samples <= render::kMostLensPoints) return;
    reader.fail(at, "'blur_samples' must be at most " + std::to_string(render::kMostLensPoints));
  };
  const int first = integer(reader, "blur_samples");
  if (first <= 0) reader.fail(at, "'blur_samples' must be above 0");
  check_most(first);
  blur.samples = first;
  blur.min_samples = 0;
  if (language_version(reader) < 350) return;
  reader.skip_comma();
  if (!reader.at_number()) return;
  const int second = integer(reader, "blur_samples");
  if (second == 0) return;
  if (first > second) reader.fail(at, "the first number of 'blur_samples' is the smaller one");
  check_most(second);
  blur.samples = second;
  blur.min_samples = first;
}

void parse_bokeh(Reader& reader, SceneContext& context, const Token& word, render::FocalBlur& blur) {
  reader.open_block(word);
  while (reader.next_is(Keyword::pigment)) {
    const Token& pigment = reader.take();
    blur.bokeh = std::make_shared<const render::Pigment>(
        parse_pigment(reader, context, pigment, default_layer(context).pigment));
  }
  reader.close_block();
}

/// Words about depth of field. False: the next word is none of them.
bool accept_blur(Reader& reader, SceneContext& context, Draft& draft) {
  render::FocalBlur& blur = draft.camera.blur;
  const Token& word = reader.peek();
  if (reader.accept(Keyword::aperture)) {
    draft.aperture_word = word;
    blur.aperture = finite_number(reader, "aperture");
  } else if (reader.accept(Keyword::blur_samples)) {
    parse_blur_samples(reader, blur);
  } else if (reader.accept(Keyword::focal_point)) {
    draft.focal_point = finite_vector(reader, "focal_point");
  } else if (reader.accept(Keyword::confidence)) {
    parse_share(reader, word, false, blur.confidence);
  } else if (reader.accept(Keyword::variance)) {
    parse_share(reader, word, true, blur.variance);
  } else if (language_version(reader) >= 350 && reader.accept(Keyword::bokeh)) {
    parse_bokeh(reader, context, word, blur);
  } else {
    return false;
  }
  return true;
}

/// Vectors of the camera. False: the next word is none of them.
bool accept_vector(Reader& reader, Draft& draft) {
  Camera& camera = draft.camera;
  if (reader.accept(Keyword::location)) {
    camera.location = finite_vector(reader, "location");
  } else if (reader.accept(Keyword::direction)) {
    camera.direction = finite_vector(reader, "direction");
  } else if (reader.accept(Keyword::up)) {
    camera.up = finite_vector(reader, "up");
    draft.up_given = true;
  } else if (reader.accept(Keyword::right)) {
    camera.right = finite_vector(reader, "right");
    draft.right_given = true;
  } else if (reader.accept(Keyword::sky)) {
    camera.sky = finite_vector(reader, "sky");
  } else {
    return false;
  }
  return true;
}

bool accept_normal(Reader& reader, SceneContext& context, Draft& draft) {
  const Token& word = reader.peek();
  if (!reader.accept(Keyword::normal)) return false;
  draft.normal_word = word;
  draft.camera.normal =
      std::make_shared<const render::Normal>(parse_normal(reader, context, word, draft.camera.normal.get()));
  return true;
}

/// The kind of camera. False: the next word names none.
bool accept_kind(Reader& reader, SceneContext& context, Draft& draft) {
  const Token& word = reader.peek();
  const auto kind = accept_camera_kind(reader, context, draft.camera.mesh);
  if (!kind) return false;
  draft.camera.kind = *kind;
  draft.kind_word = word;
  return true;
}

/// From version 3.5 on the kind comes first; the order of the other words does not matter: lengths first, then the
/// angle (which needs `right`), then where to look, then the transformations.
void parse_unordered(Reader& reader, SceneContext& context, Draft& draft) {
  while (accept_kind(reader, context, draft)) {
  }
  for (;;) {
    const Token& word = reader.peek();
    if (draft.camera.kind != CameraKind::mesh && reader.accept(Keyword::angle)) {
      parse_angle(reader, draft);
    } else if (reader.accept(Keyword::look_at)) {
      draft.look_at_word = word;
      draft.look_at = finite_vector(reader, "look_at");
    } else if (const auto transform = accept_transformation(reader)) {
      draft.transform = draft.transform.then(*transform);
    } else if (names_camera_kind(word)) {
      reader.fail(word, quoted(word) + " must be the first word of a camera");
    } else if (!accept_vector(reader, draft) && !accept_blur(reader, context, draft) &&
               !accept_normal(reader, context, draft)) {
      break;
    }
  }
  if (draft.angle) apply_angle(draft);
  if (draft.look_at) apply_look_at(reader, draft);
  const bool plane_given = draft.up_given || draft.right_given;
  if (draft.camera.kind == CameraKind::orthographic && (draft.angle || !plane_given)) {
    render::widen_to_look_at(draft.camera);
  }
  if (draft.focal_point) apply_focal_point(draft);
  render::place(draft.camera, draft.transform);
}

/// Before version 3.5 every word takes effect where it stands.
void parse_in_order(Reader& reader, SceneContext& context, Draft& draft) {
  for (;;) {
    const Token& word = reader.peek();
    if (accept_kind(reader, context, draft)) {
      if (draft.camera.kind == CameraKind::orthographic) render::widen_to_look_at(draft.camera);
    } else if (reader.accept(Keyword::angle)) {
      parse_angle(reader, draft);
      if (draft.angle) apply_angle(draft);
    } else if (reader.accept(Keyword::look_at)) {
      draft.look_at_word = word;
      draft.look_at = finite_vector(reader, "look_at");
      apply_look_at(reader, draft);
    } else if (const auto transform = accept_transformation(reader)) {
      render::place(draft.camera, *transform);
    } else if (!accept_vector(reader, draft) && !accept_blur(reader, context, draft) &&
               !accept_normal(reader, context, draft)) {
      break;
    }
    if (word.is(Keyword::focal_point)) apply_focal_point(draft);
  }
}

void warn_if_skewed(Reader& reader, const Token& word, const Camera& camera) {
  const double skew = std::max({std::abs(camera.right.dot(camera.up)), std::abs(camera.right.dot(camera.direction)),
                                std::abs(camera.up.dot(camera.direction))});
  if (skew > kTinyLength)
    reader.warn(word, "the vectors of the camera are not at right angles; 'look_at' as the last word may help");
}

/// Notes the features of the finished camera: at its words, or where a camera that it began with has asked for them.
void note_features(const Token& word, const Draft& draft, Camera& camera) {
  const render::FeatureUses before = std::exchange(camera.unrendered, {});
  const auto note = [&](render::Feature feature, const Token& own) {
    const auto same = [&](const render::FeatureUse& use) { return use.feature == feature; };
    const auto inherited = std::find_if(before.list().begin(), before.list().end(), same);
    if (own.is_end() && inherited != before.list().end()) {
      camera.unrendered.add(*inherited);
    } else {
      camera.unrendered.add(feature_use(feature, own.is_end() ? word : own));
    }
  };
  note(render::feature_of(camera.kind), draft.kind_word);
  if (camera.normal) note(render::Feature::camera_normal, draft.normal_word);
  if (camera.normal) gather(*camera.normal, camera.unrendered);
  if (camera.blur.shows()) note(render::Feature::focal_blur, draft.aperture_word);
  if (camera.blur.shows() && camera.blur.bokeh) gather(*camera.blur.bokeh, camera.unrendered);
}

}  // namespace

Camera parse_camera(Reader& reader, SceneContext& context, const Token& word, const Camera& start) {
  reader.open_block(word);
  Draft draft;
  draft.camera = start;
  const auto declared = reader.accept_declared<Camera>();
  if (declared) draft.camera = *declared;
  if (language_version(reader) < 350) {
    parse_in_order(reader, context, draft);
  } else if (declared) {
    // a declared camera can only be moved
    while (const auto transform = accept_transformation(reader)) render::place(draft.camera, *transform);
  } else {
    parse_unordered(reader, context, draft);
  }
  reader.close_block();
  Camera& camera = draft.camera;
  if (camera.blur.focal_distance < 0.0) camera.blur.focal_distance = draft.direction_length;
  if (camera.blur.focal_distance == 0.0) camera.blur.focal_distance = 1.0;
  warn_if_skewed(reader, word, camera);
  note_features(word, draft, camera);
  return camera;
}

}  // namespace firstlight::parser
