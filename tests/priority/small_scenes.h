#pragma once

#include "render/accel/accel.h"
#include "render/scene/scene.h"
#include "render/trace/medium_table.h"
#include "render/trace/trace_context.h"

#include <memory>
#include <string>
#include <vector>

namespace firstlight::priority {

/// A scene of a few objects that makes a few thousand rays of all kinds, with the table of media of one picture.
/// Objects are named Floor, Ball and Glass.
class SmallScene {
 public:
  SmallScene(std::string name, std::unique_ptr<const render::Scene> scene)
      : name_(std::move(name)), scene_(std::move(scene)), accel_(std::make_unique<render::Accel>(*scene_)) {}

  const std::string& name() const { return name_; }
  const render::Scene& scene() const { return *scene_; }
  /// With a table of media of its own.
  render::TraceContext context();

 private:
  std::string name_;
  std::unique_ptr<const render::Scene> scene_;
  std::unique_ptr<render::Accel> accel_;
  std::unique_ptr<render::MediumTable> media_;
};

/// Mirrors that face each other, five lights: more than a record of feelers holds.
SmallScene hall_of_mirrors();
/// The same, seen by a camera of which no ray leads through the corners of the picture.
SmallScene hall_through_a_fisheye();
/// The same through a lens: pixels are means of several samples.
SmallScene hall_through_a_lens();
/// Glass that bends, filters and fades what goes through, and shadows of its colours.
SmallScene coloured_glass();
/// Reflections with exponents, whose trees are traced in one go.
SmallScene mirrors_with_exponents();

/// Area lights, also of points that light one by one, a cone, and a parallel light that begins among the objects.
SmallScene lights_of_many_kinds();

std::vector<SmallScene> small_scenes();

}  // namespace firstlight::priority
