#pragma once

#include "render/math/bounds.h"
#include "render/math/ray_columns.h"
#include "render/math/shared.h"
#include "render/math/vec.h"
#include "render/scene/extent.h"
#include "render/shape/shape.h"
#include "render/shape/slots.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace firstlight::render {

/// Bits of Solid::hidden_from and of the visibility tests: the kinds of ray that an object may hide from.
constexpr std::uint8_t kHiddenFromPrimary = 1;     ///< no_image
constexpr std::uint8_t kHiddenFromReflection = 2;  ///< no_reflection
constexpr std::uint8_t kHiddenFromShadow = 4;      ///< no_shadow
/// Bit of a ray's kind, beside kHiddenFromPrimary: it has come through a surface. Hides nothing as such.
constexpr std::uint8_t kSentThrough = 8;

/// Where the inside of a solid may be.
struct Reach {
  Box3 inside = boundless_box();   ///< every point outside of it is outside the solid
  Box3 outside = boundless_box();  ///< every point outside of it is inside the solid
};

/// A question to a solid for the rays of a block.
struct BlockQuestion {
  const RayColumns& rays;
  const Columns3<double>& inverse;  ///< one over each direction; for 0 a number that is large and finite
  DepthWindow window;
  const std::vector<bool>* opaque_parts = nullptr;  ///< if given, only what lies on these parts counts
};

/// The frozen geometry of an object as rays meet it: one shape, or a combination whose crossings are filtered by its
/// members. Unions without clips or bounds do not occur at top level: scene building dissolves them.
///
/// Source   Which crossing counts is POV-Ray 3.7's rule: of an intersection, a crossing of one member that is inside
///          all others; of a merge, one that is inside none.
/// Memory   Small while it is plain: even its box is worked out when it is asked for. What other solids have besides is
///          shared by their copies.
/// Threads  Immutable once it is closed.
class Solid {
 public:
  enum class Kind : std::uint8_t { shape, union_, intersection, merge };

  Kind kind = Kind::shape;
  std::uint8_t hidden_from = 0;
  std::uint32_t part = 0;  ///< of Kind::shape: index into Scene::parts
  /// At top level: index into Scene::interiors of the object that the solid belongs to; kNoMatter: no ray starts in it.
  std::uint32_t matter = 0;
  static constexpr std::uint32_t kNoMatter = 0xffffffffu;
  ShapePtr shape;  ///< of Kind::shape

  /// World bounds of what remains visible, with room for rounding. Empty: nothing remains. Pre: closed.
  Box3 box() const;
  /// The box that POV-Ray has of it, as it was described; else of box(). Pre: closed.
  Extent extent() const;
  /// Rays that miss the extent miss the solid. Pre: closed.
  void set_extent(const Extent& extent);
  /// Whether some of it may lie outside of its extent: then box() is of the extent, and of a ray that meets the box,
  /// all crossings count.
  bool is_cramped() const;
  /// As box(), without regard to the extent.
  Box3 surface_box() const;
  const std::vector<Solid>& members() const;
  const std::vector<Solid>& clips() const;
  const std::vector<Solid>& bounds() const;
  void set_members(std::vector<Solid> members);
  void set_clips(std::vector<Solid> clips);
  void set_bounds(std::vector<Solid> bounds);
  /// Whether it is one shape that nothing cuts or bounds, as most solids are.
  bool is_plain() const { return kind == Kind::shape && structure_.is_initial(); }

  /// Finds the boxes of what is not plain; call bottom up, when the solid is complete.
  void close();

  /// Appends all crossings that belong to the solid's surface. `hidden_bit` is the bit of the asking ray's kind; it
  /// chooses among members, while whether the solid itself is hidden is the caller's to ask.
  void crossings(const Ray& ray, std::uint8_t hidden_bit, std::vector<Crossing>& out) const;
  /// The same where only the nearest crossing beyond `low` counts, and only below `high`: others may be left out.
  void nearest(const Ray& ray, std::uint8_t hidden_bit, double low, double high, std::vector<Crossing>& out) const;
  /// The nearest crossing of each ray in `who`, as nearest() tells it, of rays of a block that are all of one kind;
  /// where only opaque parts count, the nearest on these. `slots` has them until it is cleared. False: not found out,
  /// for a solid too deep or with too many crossings; one ray can still be asked.
  bool meet(const BlockQuestion& question, std::uint8_t hidden_bit, std::uint64_t who, Slots& slots,
            NearestCrossings& nearest) const;
  /// Whether the kind of a ray matters to what it meets.
  bool hides_some() const;
  /// Whether a block of rays is met sooner together than one by one.
  bool suits_blocks() const;
  bool inside(const Vec3& point) const;
  /// Returns the bits of those points in `who` that are inside. Pre: the solid suits blocks.
  std::uint64_t inside(const Columns3<double>& points, std::uint64_t who) const;
  /// Whether a ray that begins at `point`, in space, begins in the solid: in start_extent() and inside_without_clips().
  /// Source   POV-Ray 3.7: it asks the bounding box, and does not ask what clips the whole.
  bool holds_start(const Vec3& point) const;
  /// Nothing: everywhere.
  std::optional<Extent> start_extent() const;
  bool inside_without_clips(const Vec3& point) const;
  /// False only where holds_start() is false at all points of the box.
  bool may_hold_start(const Box3& points) const;

 private:
  struct Structure;
  class Meeting;

  Reach reach() const;
  bool inside_unclipped(const Vec3& point) const;
  void add_shape_crossings(const Ray& ray, std::vector<Crossing>& out) const;
  void add_member_crossings(const Solid& member, const Ray& ray, std::uint8_t hidden_bit, std::uint8_t hiding,
                            std::vector<Crossing>& out) const;
  bool reaches_bounds(const Ray& ray, std::uint8_t hidden_bit, std::vector<Crossing>& scratch) const;
  bool member_holds(std::size_t index, const Vec3& point) const;
  bool inside_all_members(const Vec3& point, const Solid* but) const;
  bool inside_any_member(const Vec3& point, const Solid* but, std::uint8_t hiding) const;
  std::uint64_t member_holds(std::size_t index, const Columns3<double>& points, std::uint64_t who) const;
  template <class Own>
  std::uint64_t inside_all_members(const Columns3<double>& points, std::uint64_t who, const Own& own) const;
  template <class Own>
  std::uint64_t inside_any_member(const Columns3<double>& points, std::uint64_t who, std::uint8_t hiding,
                                  const Own& own) const;

  Shared<Structure> structure_;
};

}  // namespace firstlight::render
