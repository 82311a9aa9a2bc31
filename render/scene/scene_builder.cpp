#include "render/scene/scene_builder.h"

#include "render/scene/extent.h"
#include "render/scene/object_table.h"
#include "render/scene/region.h"
#include "render/scene/simplify.h"
#include "render/scene/texture_table.h"
#include "render/scene/walk_members.h"
#include "render/shape/plane.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace firstlight::render {
namespace {

using Moves = std::shared_ptr<const std::vector<Transform>>;  ///< null: none

std::span<const Transform> span_of(const Moves& moves) {
  return moves ? std::span<const Transform>(*moves) : std::span<const Transform>();
}

/// A node of an object's tree hands this down to its parts.
struct Inherited {
  Transform to_world;  ///< from the space of the node's parts
  std::uint32_t texture = kNoIndex;
  std::uint32_t interior_texture = kNoIndex;
  std::uint32_t interior = kNoIndex;
  ObjectTable::Names names = 0;
  std::uint8_t hidden_from = 0;
  bool inverted = false;
  bool turned = false;  ///< inverted once at least
  bool double_illuminate = false;
  bool uv_mapping = false;  ///< of the textures
  bool hollow = false;
  Moves moves;                      ///< of the dissolved unions around, one after another, for extent()
  std::uint32_t light_group = 0;    ///< whose lights shine on it; 0: none
  std::uint32_t group_at_hand = 0;  ///< of lights that are members of the node itself
  bool in_light_group = false;
  bool global_lights = true;
  bool cuts_away = false;            ///< `cutaway_textures` stands at it or around it
  bool is_intersection = false;      ///< the node itself
  std::uint32_t cutaway = kNoIndex;  ///< of the outermost combination, where `cutaway_textures` stands in it
};

std::uint8_t hidden_bits(const Object& object) {
  return static_cast<std::uint8_t>((object.no_image ? kHiddenFromPrimary : 0) |
                                   (object.no_reflection ? kHiddenFromReflection : 0) |
                                   (object.no_shadow ? kHiddenFromShadow : 0));
}

/// The moves of what is in `object`, around which lie others that were moved by `outer`.
Moves moves_within(const Object& object, const Moves& outer) {
  std::vector<Transform> moves;
  if (object.cramped) {
    for (const std::optional<Transform>& step : object.extras->box_steps) {
      if (step) moves.push_back(*step);
    }
  } else if (!object.placement.is_identity()) {
    moves.push_back(object.placement);
  }
  if (moves.empty()) return outer;
  if (outer) moves.insert(moves.end(), outer->begin(), outer->end());
  constexpr std::size_t kMost = 32;  // more are taken together: unions are nested by the thousand
  if (moves.size() > kMost) {
    Transform all;
    for (const Transform& move : moves) all = all.then(move);
    moves = {all};
  }
  return std::make_shared<const std::vector<Transform>>(std::move(moves));
}

bool is_empty(const ObjectList& list) { return !list || list->empty(); }

bool has_surface(const Solid& solid) {
  return solid.kind == Solid::Kind::shape || std::ranges::any_of(solid.members(), has_surface);
}

/// Whether POV-Ray takes bounds of such a shape for unnecessary: it knows where the shape ends, or takes it for a
/// plane.
bool needs_no_bounds(const Shape& shape) {
  if (dynamic_cast<const Plane*>(&shape) != nullptr) return true;
  const Box3 box = shape.bounds();
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > -kBoundless || box.max[axis] < kBoundless) return true;
  }
  return false;
}

/// Room for some more at once: a list that grows step by step is there twice while it moves.
template <class T>
void make_room(std::vector<T>& list, std::size_t more) {
  const std::size_t size = list.size() + more;
  if (size > list.capacity()) list.reserve(std::max(size, 2 * list.capacity()));
}

}  // namespace

/// The scene as far as it has been described. Objects are frozen as they arrive, so the descriptions need not be kept.
struct SceneBuilder::State {
  std::unique_ptr<Scene> scene = std::make_unique<Scene>();
  TextureTable textures;
  ObjectTable objects;
  TexturePtr default_texture;   ///< of the object that is being added
  const Object* top = nullptr;  ///< that object
  /// The look of lights of that object, in the scene, to be added behind it.
  struct Look {
    std::shared_ptr<const Object> object;
    Inherited around;
  };
  std::vector<Look> looks;
  std::uint32_t light_groups = 0;           ///< so far
  std::uint32_t frozen_cutaway = kNoIndex;  ///< of the combination that was frozen last
  std::uint64_t size = 1;                   ///< of the top-level solid at hand
  bool has_camera = false;
  BoundingRules bounding;
  Shared<Interior> surroundings;  ///< see air()

  const Shared<Interior>& air();
  Inherited at_node(const Object& object, const Inherited& parent);
  void join_light_group(const Object& object, Inherited& node);
  void promote_finish(std::uint32_t texture, std::uint32_t interior);
  bool dissolves(const Object& object, const Inherited& parent) const;
  std::optional<Inherited> within(const Object& object, const Inherited& parent);
  void link(const Object& object);
  void add_solid(const Object& object, const Inherited& parent);
  void note_region(const ObjectList& objects);
  void add_shape_textures(Part& part, const Object& object, const Inherited& leaf);
  void add_light(const Object& object, const Inherited& parent);
  void add_looks();
  /// Adds what a light is projected through, and returns its number.
  std::uint32_t add_window(const Object& object);
  void note_surfaces();
  void note_atmosphere();
  bool freeze(const Object& object, const Inherited& parent, bool top_level, Solid& solid);
  Cutaway::Member cut_member(const Solid& solid) const;
  void add_part(Solid& solid, const Object& object, const Inherited& leaf);
  void finish();
};

/// Returns what holds at `object`: its own where it has it, else its parent's.
Inherited SceneBuilder::State::at_node(const Object& object, const Inherited& parent) {
  Inherited node = parent;
  const ObjectExtras& extras = object.extras;
  node.to_world = object.placement.then(parent.to_world);
  // A texture that lies in the surface's own coordinates moves with it. What has not both textures of its own is mapped
  // as its parent is. [POV-Ray 3.7]
  node.uv_mapping = object.uv_mapping || (parent.uv_mapping && !(object.texture && extras.interior_texture));
  const auto placed = [&](const Transform& placement) {
    return object.uv_mapping ? Transform() : placement.then(parent.to_world);
  };
  if (object.texture) {
    const Transform place = placed(object.texture_placement);
    // Nothing else can ask for a texture that the object at top level alone holds.
    const bool unshared = &object == top && object.texture.use_count() == 1;
    node.texture =
        unshared ? textures.index_of_unshared(object.texture, place) : textures.index_of(object.texture, place);
  }
  if (extras.interior_texture) {
    node.interior_texture = textures.index_of(extras.interior_texture, placed(extras.interior_texture_placement));
  }
  // Parts of a whole that shows what it cuts may have none.
  node.cuts_away = parent.cuts_away || object.cutaway_textures;
  node.is_intersection = false;
  const bool may_have_none = parent.cuts_away && parent.is_intersection;
  const bool needs_one = object.kind == Object::Kind::shape || (node.cuts_away && !object.textured);
  if (node.texture == kNoIndex && needs_one && default_texture && !may_have_none) {
    node.texture = textures.index_of(default_texture, Transform());
  }
  scene->unrendered.add(extras.unrendered);
  if (extras.interior) {
    node.interior = static_cast<std::uint32_t>(scene->interiors.size());
    scene->interiors.push_back(moved(*extras.interior, parent.to_world));
    gather(*scene->interiors.back(), scene->unrendered);
  } else if (node.interior == kNoIndex) {
    node.interior = static_cast<std::uint32_t>(scene->interiors.size());
    scene->interiors.push_back(air());
  }
  if (node.texture != kNoIndex) promote_finish(node.texture, node.interior);
  // The last of those that share an interior has its way. [POV-Ray 3.7]
  if (object.hollow != Object::Hollow::inherited) node.hollow = object.hollow == Object::Hollow::yes;
  if (scene->interiors[node.interior]->hollow != node.hollow) {
    scene->interiors[node.interior].change().hollow = node.hollow;
  }
  node.hidden_from |= hidden_bits(object);
  if (!extras.names.empty()) node.names = objects.within(parent.names, extras.names);
  node.inverted = parent.inverted != object.inverted;
  node.turned |= object.turned;
  node.double_illuminate |= object.double_illuminate;
  join_light_group(object, node);
  return node;
}

/// A group without lights, or without anything that they could shine on, is a union like any other, but for the lights
/// of the scene. Of groups within groups, the innermost says which group's lights shine, and the outermost whether the
/// scene's do. [POV-Ray 3.7]
void SceneBuilder::State::join_light_group(const Object& object, Inherited& node) {
  node.group_at_hand = 0;
  const ObjectExtras& extras = object.extras;
  if (!extras.light_group) return;
  if (!node.in_light_group) node.global_lights = extras.global_lights;
  node.in_light_group = true;
  if (!object.children) return;
  const auto is_light = [](const Object& member) { return member.kind == Object::Kind::light; };
  if (std::ranges::none_of(*object.children, is_light) || std::ranges::all_of(*object.children, is_light)) return;
  node.light_group = node.group_at_hand = ++light_groups;
}

/// The interior of objects of which nothing is said. All share it.
const Shared<Interior>& SceneBuilder::State::air() {
  const double ior = scene->settings.atmosphere_ior;
  if (surroundings->ior != ior) surroundings.change().ior = ior;
  return surroundings;
}

/// Old scenes give the index of refraction in the finish. Parts that share an interior share what the last of them
/// says.
void SceneBuilder::State::promote_finish(std::uint32_t texture, std::uint32_t interior) {
  Shared<Interior>& matter = scene->interiors[interior];
  const Texture& look = textures.texture(texture);
  if (!look.layers.empty() && !look.layers.front().extras->patterned) {
    const Finish& finish = look.layers.front().finish;
    if (finish.legacy_ior > 0.0) {
      matter.change().ior = finish.legacy_ior;
      matter.change().dispersion = 1.0;
    }
    if (finish.legacy_caustics >= 0.0) matter.change().caustics = finish.legacy_caustics / 45.0;
    if (matter->refraction_scale != finish.legacy_refraction) {
      matter.change().refraction_scale = finish.legacy_refraction;
    }
  }
  if (matter->ior == 0.0) matter.change().ior = scene->settings.atmosphere_ior;
}

/// Whether `object` is a union that is nothing but its members, as POV-Ray has it.
bool SceneBuilder::State::dissolves(const Object& object, const Inherited& parent) const {
  if (object.kind != Object::Kind::union_ || object.turned || parent.turned) return false;
  const ObjectExtras& extras = object.extras;
  if (!is_empty(extras.clipped_by) || !object.split_union) return false;
  if (is_empty(extras.bounded_by) || extras.light_group || is_empty(object.children)) return true;
  const Moves moves = moves_within(object, parent.moves);
  return bounding.split_unions && std::ranges::none_of(*object.children, [&](const Object& child) {
           return extent(child, span_of(moves)).is_unbounded();
         });
}

/// Returns what holds in a union that dissolves; nothing for any other object.
std::optional<Inherited> SceneBuilder::State::within(const Object& object, const Inherited& parent) {
  if (!dissolves(object, parent)) return std::nullopt;
  if (is_empty(object.children)) return parent;
  Inherited node = at_node(object, parent);
  node.moves = moves_within(object, parent.moves);
  make_room(scene->solids, object.children->size());
  make_room(scene->parts, object.children->size());
  return node;
}

/// Makes top-level solids of `object`. Those of a union that dissolves are its members': rays meet them faster one by
/// one. They keep their order, for of members that meet a ray at equal depths POV-Ray shows the first.
void SceneBuilder::State::link(const Object& object) {
  const auto enter = [this](const Object& member, const Inherited& parent) { return within(member, parent); };
  const auto visit = [this](const Object& member, const Inherited& parent) { add_solid(member, parent); };
  if (const auto inside = within(object, Inherited())) {
    walk_members(object, *inside, enter, visit);
  } else {
    add_solid(object, Inherited());
  }
}

void SceneBuilder::State::add_solid(const Object& object, const Inherited& parent) {
  size = object.size;
  Solid& solid = scene->solids.emplace_back();
  if (!freeze(object, parent, true, solid) || !has_surface(solid)) {
    scene->solids.pop_back();
    return;
  }
  if (object.cramped || !solid.is_plain()) solid.set_extent(extent(object, span_of(parent.moves)));
}

/// Makes of `object` one solid, closed. False for a light, which goes to the scene's lights, and for what is no solid.
/// Pre: `solid` is as it was made.
bool SceneBuilder::State::freeze(const Object& object, const Inherited& parent, bool top_level, Solid& solid) {
  if (object.kind == Object::Kind::light) {
    add_light(object, parent);
    return false;
  }
  Inherited node = at_node(object, parent);
  if (top_level) solid.matter = node.interior;
  if (object.kind == Object::Kind::shape && !object.shape) return false;
  solid.kind = solid_kind(object.kind, node.inverted);
  // The complement of a union's complement is a merge. [POV-Ray 3.7]
  if (node.turned && solid.kind == Solid::Kind::union_) solid.kind = Solid::Kind::merge;
  solid.hidden_from = node.hidden_from;
  node.is_intersection = solid.kind == Solid::Kind::intersection;
  std::uint32_t cutaway = kNoIndex;
  if (object.kind != Object::Kind::shape && (object.cuts_away || node.cutaway != kNoIndex)) {
    cutaway = static_cast<std::uint32_t>(scene->cutaways.size());
    scene->cutaways.emplace_back().first_alone = object.difference;
    if (node.cutaway == kNoIndex) node.cutaway = cutaway;
  }
  if (object.kind == Object::Kind::shape) {
    solid.shape = placed_shape(object, node.to_world, node.inverted);
    add_part(solid, object, node);
  } else if (object.children) {
    std::vector<Solid> members;
    members.reserve(object.children->size());
    const bool deep = object.nesting > kMostDepth && object.kind == Object::Kind::union_;
    const auto enter = [&](const Object& child, const Inherited& around) {
      return deep && is_plain_union(child) ? std::optional(at_node(child, around)) : std::nullopt;
    };
    std::vector<Cutaway::Member> cut;
    walk_members(object, node, enter, [&](const Object& child, const Inherited& around) {
      Solid& member = members.emplace_back();
      if (!freeze(child, around, false, member)) {
        members.pop_back();
      } else if (cutaway != kNoIndex) {
        cut.push_back(cut_member(member));
      }
    });
    if (cutaway != kNoIndex) scene->cutaways[cutaway].members = std::move(cut);
    solid.set_members(std::move(members));
  }
  if (!object.extras.is_initial()) {
    note_region(object.extras->clipped_by);
    note_region(object.extras->bounded_by);
    solid.set_clips(regions(clips_of(object), node.to_world));
    const bool drops_bounds =
        bounding.remove_bounds && top_level && object.kind == Object::Kind::shape && needs_no_bounds(*object.shape);
    if (!drops_bounds) solid.set_bounds(bounding_regions(bounds_of(object), node.to_world));
  }
  solid.close();
  frozen_cutaway = cutaway;
  return true;
}

/// The solid that has just been frozen, as what contains it asks for its texture.
Cutaway::Member SceneBuilder::State::cut_member(const Solid& solid) const {
  const bool is_shape = solid.kind == Solid::Kind::shape;
  return {solid, is_shape ? scene->parts[solid.part].texture : kNoIndex, is_shape ? kNoIndex : frozen_cutaway};
}

void SceneBuilder::State::add_light(const Object& object, const Inherited& parent) {
  scene->unrendered.add(object.extras->unrendered);
  scene->unrendered.add(object.extras->light->unrendered);
  Light light = placed_with_objects(object.extras->light, object.placement.then(parent.to_world));
  light.group = parent.group_at_hand;
  const ObjectTable::Names names = objects.within(parent.names, object.extras->names);
  if (light.looks_like) {
    Look& look = looks.emplace_back(Look{light.looks_like, parent});
    look.around.to_world = Transform();
    look.around.moves = nullptr;
    look.around.inverted = false;
    look.around.turned = false;
    look.around.names = names;
    look.around.cuts_away = false;
    look.around.cutaway = kNoIndex;
    look.around.global_lights = true;  // [POV-Ray 3.7] also in a light group
  }
  if (light.projected_through) light.window = add_window(*light.projected_through);
  scene->lights.push_back(std::move(light));
  scene->light_names.push_back(objects.names_of(names));
}

// One solid each, whatever it is made of. Nothing is said of what is inside of a light. [POV-Ray 3.7]
void SceneBuilder::State::add_looks() {
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Look look = looks[i];
    size = look.object->size;
    Solid& solid = scene->solids.emplace_back();
    const bool found = freeze(*look.object, look.around, false, solid);
    if (!found || !has_surface(solid)) {
      scene->solids.pop_back();
      continue;
    }
    solid.matter = Solid::kNoMatter;
    if (look.object->cramped || !solid.is_plain()) solid.set_extent(extent(*look.object));
  }
  looks.clear();
}

std::uint32_t SceneBuilder::State::add_window(const Object& object) {
  State apart;
  apart.scene->settings = scene->settings;
  Solid solid;
  if (!apart.freeze(object, Inherited(), false, solid)) solid = Solid();
  scene->unrendered.add(apart.scene->unrendered);
  scene->windows.push_back(std::move(solid));
  return static_cast<std::uint32_t>(scene->windows.size() - 1);
}

/// Clips and bounds are shapes without surfaces: only what they are made of counts.
void SceneBuilder::State::note_region(const ObjectList& objects) {
  if (!objects) return;
  const auto look = [this](const Object& object, bool) {
    scene->unrendered.add(object.extras->unrendered);
    note_region(object.extras->clipped_by);
    note_region(object.extras->bounded_by);
    return std::optional(true);
  };
  for (const Object& object : *objects) {
    look(object, true);
    walk_members(object, true, look, [](const Object&, bool) {});
  }
}

void SceneBuilder::State::note_surfaces() {
  for (const PlacedTexture& placed : scene->textures) {
    gather(*placed.texture, scene->unrendered);
  }
}

void SceneBuilder::State::add_part(Solid& solid, const Object& object, const Inherited& leaf) {
  Part part;
  part.texture = leaf.texture;
  part.interior_texture = leaf.interior_texture;
  part.interior = leaf.interior;
  part.opaque = leaf.texture != kNoIndex && textures.opaque(leaf.texture) &&
                (leaf.interior_texture == kNoIndex || textures.opaque(leaf.interior_texture));
  const SurfaceKind surface = leaf.texture == kNoIndex ? SurfaceKind::plain : textures.kind(leaf.texture);
  part.object = objects.group(leaf.names, object.word, surface, size);
  part.inverted = leaf.inverted;
  part.uv_mapping = leaf.uv_mapping;
  if (!object.extras->shape_textures.empty()) add_shape_textures(part, object, leaf);
  if (leaf.cuts_away && leaf.texture == kNoIndex && !part.has_shape_textures) {
    part.cutaway = leaf.cutaway;
    part.has_shape_textures = true;
  }
  part.double_illuminate = leaf.double_illuminate;
  part.light_group = leaf.light_group;
  part.global_lights = leaf.global_lights;
  solid.part = static_cast<std::uint32_t>(scene->parts.size());
  scene->parts.push_back(part);
}

void SceneBuilder::State::add_shape_textures(Part& part, const Object& object, const Inherited& leaf) {
  part.has_shape_textures = true;
  part.shape_textures = static_cast<std::uint32_t>(scene->shape_textures.size());
  for (const TexturePtr& texture : object.extras->shape_textures) {
    const std::uint32_t index = textures.index_of(texture, leaf.uv_mapping ? Transform() : leaf.to_world);
    scene->shape_textures.push_back(index);
    part.opaque = part.opaque && textures.opaque(index);
  }
}

void SceneBuilder::State::note_atmosphere() {
  const Atmosphere& atmosphere = scene->atmosphere;
  for (const Fog& fog : atmosphere.fogs) scene->unrendered.add(fog.unrendered);
  for (const Rainbow& rainbow : atmosphere.rainbows) scene->unrendered.add(rainbow.unrendered);
  for (const Media& media : atmosphere.media) gather(media, scene->unrendered);
  if (!atmosphere.sky_sphere) return;
  scene->unrendered.add(atmosphere.sky_sphere->unrendered);
  for (const Pigment& pigment : atmosphere.sky_sphere->pigments) gather(pigment, scene->unrendered);
}

void SceneBuilder::State::finish() {
  scene->textures = textures.take();
  scene->objects = objects.take();
  note_surfaces();
}

SceneBuilder::SceneBuilder() : state_(std::make_unique<State>()) {}
SceneBuilder::~SceneBuilder() = default;
SceneBuilder::SceneBuilder(SceneBuilder&&) noexcept = default;
SceneBuilder& SceneBuilder::operator=(SceneBuilder&&) noexcept = default;

void SceneBuilder::set_camera(const Camera& camera) {
  state_->scene->camera = camera;
  state_->has_camera = true;
}

bool SceneBuilder::has_camera() const { return state_->has_camera; }
Settings& SceneBuilder::settings() { return state_->scene->settings; }
const Settings& SceneBuilder::settings() const { return state_->scene->settings; }
Atmosphere& SceneBuilder::atmosphere() { return state_->scene->atmosphere; }

void SceneBuilder::set_bounding(const BoundingRules& rules) { state_->bounding = rules; }

void SceneBuilder::add(const Object& object, const TexturePtr& default_texture) {
  if (state_->default_texture != default_texture) state_->default_texture = default_texture;
  state_->top = &object;
  state_->link(object);
  state_->add_looks();
  state_->top = nullptr;
}

std::size_t SceneBuilder::object_count() const { return state_->scene->solids.size(); }

std::unique_ptr<const Scene> SceneBuilder::build() {
  state_->finish();
  state_->note_atmosphere();
  state_->scene->unrendered.add(state_->scene->camera.unrendered);
  state_->scene->unrendered.add(state_->scene->settings.unrendered);
  simplify(*state_->scene);
  std::unique_ptr<const Scene> scene = std::move(state_->scene);
  state_ = std::make_unique<State>();
  return scene;
}

}  // namespace firstlight::render
