#include "app/load_scene.h"

#include "app/exit_code.h"
#include "app/output.h"
#include "app/raw_terminal.h"
#include "app/repeats.h"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace firstlight::app {

namespace {

/// Ends the program when it was asked to stop and does not come to an end by itself soon. While a scene is read there
/// is no picture to be lost, and what is long is not only reading: to build a scene, or to free a million objects.
class Patience {
 public:
  explicit Patience(const std::atomic<bool>& stop) : thread_([this, &stop] { watch(stop); }) {}
  ~Patience() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

 private:
  void watch(const std::atomic<bool>& stop) {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    while (!over_ && !stop) changed_.wait_for(lock, 10ms);
    if (changed_.wait_for(lock, 30ms, [this] { return over_; })) return;
    RawTerminal::restore();
    say_error("reading the scene was stopped");
    std::_Exit(kExitInterrupted);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace

render::LoadResult load_scene(const Options& options, const render::FrontEnd& front_end, ProgressLine& line,
                              const std::atomic<bool>& stop) {
  render::LoadOptions load;
  load.width = options.width;
  load.height = options.height;
  load.library_paths = options.library_paths;
  load.permission_files = options.permission_files;
  load.declares = options.declares;
  load.clock = options.clock;
  load.bounding = options.bounding;
  load.quality = options.quality;
  load.parse_only = options.parse_only;
  std::size_t shown = 0;
  Repeats repeats;
  const auto show = [&](const render::Diagnostic& diagnostic) {
    ++shown;
    if (!repeats.is_new(diagnostic)) return;
    if (options.quiet && diagnostic.severity != render::Diagnostic::Severity::error) return;
    line.clear();
    // The scene's own output is as POV-Ray writes it: as it is, so that pieces can make up a line.
    const bool own = diagnostic.severity == render::Diagnostic::Severity::debug;
    own ? say_piece(diagnostic.message) : say(render::format(diagnostic));
  };
  load.report = show;
  load.stop = &stop;
  load.progress = [&](const render::ParseProgress& progress) {
    line.stage(fmt::format("reading {}:{}, {} words, {} objects", progress.file, progress.line,
                           short_count(progress.tokens), short_count(progress.objects)));
  };
  const Patience patience(stop);
  render::LoadResult result = front_end.load(options.scene, load);
  // A front end of another making may not report as it reads.
  for (std::size_t i = shown; i < result.diagnostics.size(); ++i) show(result.diagnostics[i]);
  for (const render::Diagnostic& note : repeats.counts()) show(note);
  return result;
}

}  // namespace firstlight::app
