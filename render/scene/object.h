#pragma once

#include "render/feature/feature.h"
#include "render/light/light.h"
#include "render/math/shared.h"
#include "render/math/transform.h"
#include "render/scene/photon_role.h"
#include "render/shape/shape.h"
#include "render/texture/interior.h"
#include "render/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::render {

struct Object;

using ObjectList = std::shared_ptr<const std::vector<Object>>;  ///< null: none
/// A list that is taken apart without recursion, however deep what it holds is nested.
ObjectList make_object_list(std::vector<Object> objects);

/// Attributes that few objects have.
struct ObjectExtras {
  Shared<Light> light = {};       ///< of Kind::light
  ObjectList clipped_by = {};     ///< points of the surface outside any of these are cut away
  ObjectList bounded_by = {};     ///< rays that miss any of these miss the object
  bool bounds_are_clips = false;  ///< bounded_by { clipped_by }

  std::vector<TexturePtr> shape_textures = {};  ///< of Kind::shape: the shape's own list, in its space
  TexturePtr interior_texture = {};             ///< seen from inside; null: inherited, or as outside
  Transform interior_texture_placement = {};
  std::optional<Shared<Interior>> interior = {};  ///< not set: inherited

  std::optional<double> radiosity_importance = {};  ///< above 0, at most 1; not set: the scene's default
  PhotonRole photons = {};
  /// A union whose lights shine on its own objects only; `global_lights`: which those of the scene light too.
  bool light_group = false;
  bool global_lights = false;
  /// Identifiers it was declared under, for choosing objects by name, the outermost first: `#declare A = object { B }`
  /// makes {"A", "B"} of both. At most kMostNames.
  std::vector<std::string> names = {};
  /// If a combination is `cramped`: what has been done to its bounding box since it was combined. A move, or
  /// nothing where its bounds and clips were put about it.
  std::vector<std::optional<Transform>> box_steps = {};
  FeatureUses unrendered = {};  ///< what the object's own words ask for; children and surfaces carry theirs

  static constexpr std::size_t kMostNames = 8;
};

/// A thing in the scene as it is described: one shape or light, or several combined. A cheap value: the shape and the
/// children are shared, so copying a declared object costs the same whatever its size. Scene building walks the
/// tree and hands placements, textures and flags down to the leaves.
///
/// Memory   Unions hold their parts by the hundred thousand, so what few objects have is apart from them.
struct Object {
  enum class Kind : std::uint8_t { shape, light, union_, intersection, merge };
  /// Whether what surrounds the object is in it too.
  enum class Hollow : std::uint8_t { inherited, no, yes };

  Kind kind = Kind::shape;
  bool inverted = false;
  bool turned = false;  ///< it has been inverted, if only to be inverted back: then it is no union but a merge
  Hollow hollow = Hollow::inherited;
  bool no_shadow = false;
  bool no_image = false;
  bool no_reflection = false;
  bool double_illuminate = false;
  bool uv_mapping = false;        ///< textures go by the shape's own coordinates, not by space
  bool cutaway_textures = false;  ///< of an intersection: parts without a texture have those of what they cut
  bool cuts_away = false;         ///< it or something in it has `cutaway_textures`
  bool difference = false;        ///< of an intersection: what its first member is left with
  bool split_union = true;        ///< of a union: its parts may be bounded one by one
  bool sturm = false;             ///< polynomials are solved the slow and sure way
  bool hierarchy = true;          ///< parts of the shape may be bounded
  bool no_radiosity = false;
  bool textured = false;  ///< it or something in it has a texture of its own
  bool patch = false;     ///< it or something in it is a surface without an inside, such as a triangle
  /// Its bounding box may be smaller than it is, and rays that miss the box miss the object: it is clipped or bounded,
  /// or has a negative radius, or something in it is so or a disc. See extent().
  bool cramped = false;
  /// How deep and how large the tree below is. Sharing lets a short text describe trees that no machine can walk;
  /// whoever builds an object keeps these in step, and the front end refuses too large ones.
  /// Levels of children, clips and bounds below this object; a plain union in a union is no level of its own.
  std::uint32_t depth = 0;
  std::uint32_t nesting = 0;  ///< the same with all unions
  std::uint64_t size = 1;     ///< objects in it, itself among them, each as often as it occurs

  ShapePtr shape;       ///< of Kind::shape; its space is this object's
  ObjectList children;  ///< of the combining kinds (a difference is an intersection with inverted further children)
  /// Object to parent. Moves shape, children, clips and bounds, and every texture inside them.
  Transform placement;
  /// Null: inherited from the parent, or the default texture at top level. `texture_placement` moves it to the parent's
  /// space: it holds only the transformations that came after the texture in the scene text.
  TexturePtr texture;
  Transform texture_placement;
  std::string_view word;  ///< of Kind::shape: the word of the scene language that made it; static text
  Shared<ObjectExtras> extras;
};

/// Levels that can be walked by recursion: the most that Object::depth may be. Unions in unions go deeper.
constexpr std::uint32_t kMostDepth = 1000;
/// A union that nothing cuts, bounds or turns inside out: in another union it is nothing but its members.
bool is_plain_union(const Object& object);

/// Exchanges inside and outside.
void invert(Object& object);
/// Moves the object on, with its textures.
void place(Object& object, const Transform& transform);
/// To be called at the end of what is said about an object: its bounds and clips are put about it.
void finish_box(Object& object);
/// The light moved on, with the objects that belong to it.
Light placed_with_objects(const Light& light, const Transform& transform);

}  // namespace firstlight::render
