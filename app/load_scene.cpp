#include "app/load_scene.h"

#include "app/output.h"

#include <fmt/format.h>

namespace firstlight::app {

render::LoadResult load_scene(const Options& options, const render::FrontEnd& front_end, ProgressLine& line,
                              const std::atomic<bool>* stop) {
  render::LoadOptions load;
  load.width = options.width;
  load.height = options.height;
  load.library_paths = options.library_paths;
  load.permission_files = options.permission_files;
  load.declares = options.declares;
  load.clock = options.clock;
  load.bounding = options.bounding;
  load.parse_only = options.parse_only;
  std::size_t shown = 0;
  const auto show = [&](const render::Diagnostic& diagnostic) {
    ++shown;
    if (options.quiet && diagnostic.severity != render::Diagnostic::Severity::error) return;
    line.clear();
    // The scene's own output is as POV-Ray writes it: as it is, so that pieces can make up a line.
    const bool own = diagnostic.severity == render::Diagnostic::Severity::debug;
    own ? say_piece(diagnostic.message) : say(render::format(diagnostic));
  };
  load.report = show;
  load.stop = stop;
  load.progress = [&](const render::ParseProgress& progress) {
    line.stage(fmt::format("reading {}:{}, {} words, {} objects", progress.file, progress.line,
                           short_count(progress.tokens), short_count(progress.objects)));
  };
  render::LoadResult result = front_end.load(options.scene, load);
  // A front end of another making may not report as it reads.
  for (std::size_t i = shown; i < result.diagnostics.size(); ++i) show(result.diagnostics[i]);
  return result;
}

}  // namespace firstlight::app
