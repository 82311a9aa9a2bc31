#include "render/shape/blob.h"

#include "render/math/box_tree.h"
#include "render/shape/blob_rays.h"
#include "render/shape/canonical.h"
#include "render/shape/placed.h"
#include "render/shape/slots.h"
#include "render/shape/tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace firstlight::render {
namespace {

constexpr double kInsideRoom = 1e-6;  ///< POV-Ray's for this shape, of the field
constexpr std::size_t kFew = 8;       ///< elements that are asked one by one

using Element = BlobElement;

/// A blob in its own space.
struct Blob {
  static constexpr bool kIsLarge = true;

  double threshold;
  std::vector<Element> elements;
  std::optional<BoxTree> tree;  ///< over the elements' boxes; none of few
  Box3 positive;                ///< around the elements that add to the field
  Box3 all;

  explicit Blob(const BlobParameters& parameters) : threshold(parameters.threshold) {
    for (const BlobParameters::Component& component : parameters.components) add(component);
    std::vector<Box3> boxes;
    for (const Element& element : elements) {
      boxes.push_back(element.bounds());
      all.extendBy(boxes.back());
      if (element.c2 > 0.0) positive.extendBy(boxes.back());
    }
    if (elements.size() > kFew) tree.emplace(boxes);
  }

  void meet(const Ray& ray, Met& met) const {
    const Column<double> low = alone(met.low());
    for (const BlobCrossing& crossing : crossings(Transform(), alone(ray), 1, met.wants_all() ? nullptr : &low)) {
      met.add(crossing.depth);
    }
  }
  void meet_block(const RaysAndPlace& asked, Slots& slots) const {
    SlotLists lists(asked.shape, slots, false);
    for (const BlobCrossing& crossing : crossings(asked.transform, asked.rays, asked.who,
                                                  asked.nearest_only == nullptr ? nullptr : &asked.nearest_only->low)) {
      lists.add(crossing.ray, crossing.depth);
    }
  }
  bool inside(const Vec3& point, bool inverted) const {
    double sum = 0.0;
    for_each_around(point, [&](const Element& element) { sum += element.field(point); });
    return (sum > threshold - kInsideRoom) != inverted;
  }
  Vec3 normal(const Vec3& point, const Crossing&) const {
    Vec3 sum(0.0);
    for_each_around(point, [&](const Element& element) { sum += element.normal(point); });
    return sum == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : sum.normalized();
  }
  /// Each element's has the share that its field has of all.
  void textures(const SurfacePlaces& places, std::size_t first, std::size_t end, std::vector<TextureShare>& out) const {
    for (std::size_t place = first; place < end; ++place) {
      const Vec3 point = places.point.vector(place);
      const std::size_t begin = out.size();
      double sum = 0.0;
      for_each_around(point, [&](const Element& element) {
        const double weight = std::abs(element.field(point));
        if (!(weight > 0.0)) return;
        out.push_back({static_cast<std::uint32_t>(place), element.texture, weight});
        sum += weight;
      });
      for (std::size_t i = begin; i < out.size(); ++i) out[i].weight /= sum;
    }
  }
  Box3 bounds() const { return threshold > 0.0 ? positive : all; }
  Box3 given_bounds() const { return positive; }
  Box3 inside_bounds() const { return threshold > kInsideRoom ? positive : boundless_box(); }

 private:
  void add(const BlobParameters::Component& component) {
    const double r2 = component.radius * component.radius;
    Element element{Element::Kind::ball,
                    component.center,
                    0.0,
                    r2,
                    component.strength / (r2 * r2),
                    -2.0 * component.strength / r2,
                    component.strength,
                    component.placement,
                    component.texture};
    if (component.kind == BlobParameters::Component::Kind::sphere) {
      elements.push_back(element);
      return;
    }
    const Vec3 axis = component.end - component.center;
    element.height = axis.length();
    element.placement = from_canonical(component.center, unit(axis), 1.0, 1.0).then(component.placement);
    for (const Element::Kind kind : {Element::Kind::middle, Element::Kind::base, Element::Kind::top}) {
      element.kind = kind;
      elements.push_back(element);
    }
  }
  /// Until the next call of this thread.
  const std::vector<BlobCrossing>& crossings(const Transform& transform, const RayColumns& rays, std::uint64_t who,
                                             const Column<double>* low) const {
    thread_local std::vector<BlobCrossing> found;
    found.clear();
    meet_blob({threshold, elements, tree ? &*tree : nullptr}, transform, rays, who, low, found);
    return found;
  }
  template <class Visit>
  void for_each_around(const Vec3& point, const Visit& visit) const {
    if (!tree) {
      std::ranges::for_each(elements, visit);
      return;
    }
    tree->any_around(point, [&](std::uint32_t element) {
      visit(elements[element]);
      return false;
    });
  }
};

}  // namespace

ShapePtr make_blob(const BlobParameters& parameters) {
  return std::make_shared<Placed<Blob>>(Blob(parameters), Transform());
}

}  // namespace firstlight::render
