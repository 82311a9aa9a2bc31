#pragma once

#include "app/front_ends.h"
#include "app/options.h"
#include "app/progress.h"
#include "priority/driver.h"
#include "priority/scheme_input.h"
#include "render/accel/accel.h"
#include "render/camera/projection.h"
#include "render/film/antialias_settings.h"
#include "render/film/film.h"
#include "render/math/interrupt.h"
#include "render/scene/front_end.h"

#include <atomic>
#include <optional>
#include <string>

namespace firstlight::app {

/// One scene in the hands of a command: it is read, looked at, traced as often as the command wants, and its pictures are
/// written. All as the options have it; how the rays are ordered and who watches is the command's to say.
///
/// Order     load(), build(), then trace(). Nothing but these may be called before load() was true.
/// Lifetime  `options`, `line` and `stop` outlive it; it outlives what was made of its scene.
/// Threads   The one that made it, whose long loops end when `stop` becomes true.
class Session {
 public:
  Session(const Options& options, ProgressLine& line, const std::atomic<bool>& stop);

  /// Why no scene can be read: the chosen front end cannot be opened. Empty when it could.
  const std::string& error() const { return front_end_.error(); }
  /// Reads the scene, and says what its front end has to say about it. False when there is none.
  bool load();
  /// Makes the hierarchy.
  void build(render::Foresight foresight = render::Foresight::some);
  /// With which the program ends when there is no scene.
  int exit_code() const;

  const render::Scene& scene() const { return *loaded_.scene; }
  const render::SceneSummary& summary() const { return loaded_.summary; }
  render::View view() const { return {scene().camera, options_.width, options_.height}; }
  double parse_seconds() const { return parse_seconds_; }
  double build_seconds() const { return build_seconds_; }

  /// The facts that a scheme for a picture may know. `film` may be null.
  priority::SchemeInput scheme_input(const render::Film* film) const;
  /// Everything but the order and those who watch.
  priority::TraceOptions trace_options() const;
  /// Pre: `film` has the view's size.
  priority::TraceResult trace(render::Film& film, const priority::TraceOptions& options) const;
  /// Writes the film as it is, holes between its samples filled. Empty, or why that failed.
  std::string write(const std::string& path, const render::Film& film) const;

 private:
  const Options& options_;
  ProgressLine& line_;
  const std::atomic<bool>& stop_;
  const render::Interrupt interrupt_;
  const ChosenFrontEnd front_end_;  // before the scene, whose code may be in its module
  render::LoadResult loaded_;
  std::optional<render::AntialiasSettings> antialias_;
  std::optional<render::Accel> accel_;
  double parse_seconds_ = 0.0;
  double build_seconds_ = 0.0;
};

}  // namespace firstlight::app
