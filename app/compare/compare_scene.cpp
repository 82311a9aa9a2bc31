#include "app/compare/compare_scene.h"

#include "app/compare/difference.h"
#include "app/compare/process.h"
#include "app/compare/programs.h"
#include "app/compare/scratch_folder.h"
#include "app/heap.h"
#include "render/image/image_io.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

bool stopped(const CompareSettings& settings) { return settings.stop != nullptr && *settings.stop; }

void announce(const CompareSettings& settings, const std::string& name, std::string_view program, int round) {
  if (!settings.say) return;
  settings.say(settings.rounds > 1 ? fmt::format("{}: {}, round {} of {}", name, program, round + 1, settings.rounds)
                                   : fmt::format("{}: {}", name, program));
}

void take_over(SceneRun run, const fs::path& picture, Rendered& out) {
  if (run.error.empty()) {
    out.runs.push_back(run.times);
    out.picture = picture;
  } else {
    out = Rendered{{}, {}, std::move(run.error), {}};
  }
}

/// Both programs in turn, until one fails. Nothing in it counts when it was stopped.
void render_both(const SceneJob& job, const CompareSettings& settings, const ScratchFolder& scratch, Rendered& povray,
                 Rendered& ours) {
  if (job.povray != nullptr) povray = *job.povray;
  // Freed memory would be counted as that of child processes, for they begin as copies of this one.
  give_back_freed_memory();
  for (int round = 0; round < settings.rounds; ++round) {
    if (job.povray == nullptr) {
      announce(settings, job.name, "POV-Ray", round);
      take_over(run_povray(job, settings, scratch / "povray.png"), scratch / "povray.png", povray);
      if (stopped(settings)) return;
    }
    announce(settings, job.name, "Firstlight", round);
    SceneRun run = run_firstlight(job, settings, scratch / "firstlight.png");
    if (stopped(settings)) return;
    const bool refused = !run.error.empty() && run.process.exit_code > 0;
    take_over(std::move(run), scratch / "firstlight.png", ours);
    if (refused) ours.missing = missing_features(job, settings);
    if (!povray.error.empty() || !ours.error.empty()) return;
  }
}

/// Whole or not at all. Empty, or what is wrong.
std::string keep(const fs::path& from, const fs::path& to) {
  const fs::path part = to.string() + ".part";
  std::error_code error;
  fs::copy_file(from, part, fs::copy_options::overwrite_existing, error);
  if (!error) fs::rename(part, to, error);
  if (!error) return {};
  const std::string why = error.message();
  fs::remove(part, error);
  return fmt::format("cannot write '{}': {}", to.string(), why);
}

/// Reads what a program wrote. What cannot be read counts as not rendered.
render::Picture read_picture(Rendered& rendered) {
  std::string why;
  render::Picture picture;
  if (rendered.error.empty()) picture = render::read_image(rendered.picture.string(), why);
  if (!why.empty()) rendered = Rendered{{}, {}, why, {}};
  return picture;
}

Status status_of(const Rendered& povray, const Rendered& ours) {
  if (!povray.error.empty()) return ours.error.empty() ? Status::povray_failed : Status::both_failed;
  return ours.missing.empty() ? Status::ours_failed : Status::lacks_features;
}

std::string message_of(const Rendered& povray, const Rendered& ours) {
  if (povray.error.empty()) return ours.error;
  return ours.error.empty() ? povray.error : fmt::format("POV-Ray: {}; Firstlight: {}", povray.error, ours.error);
}

void fill(const SceneJob& job, const CompareSettings& settings, Rendered& povray, Rendered& ours, SceneRecord& record) {
  const render::Picture theirs = read_picture(povray);
  const render::Picture own = read_picture(ours);
  record.povray = povray.runs;
  record.ours = ours.runs;
  record.missing = ours.missing;
  record.povray_message = povray.error;
  record.message = message_of(povray, ours);
  if (!povray.error.empty() || !ours.error.empty()) {
    record.status = status_of(povray, ours);
  } else if (theirs.width != own.width || theirs.height != own.height) {
    record.status = Status::other_size;
    record.message = fmt::format("POV-Ray's picture has {}x{} pixels, Firstlight's {}x{}", theirs.width, theirs.height,
                                 own.width, own.height);
  } else {
    record.difference = difference(theirs, own);
    record.status = judge(*record.difference, settings.thresholds);
  }
  if (job.pictures.empty()) return;
  const auto keep_picture = [&](const Rendered& rendered, const char* name, fs::path& kept) {
    if (rendered.picture.empty()) return;
    kept = job.pictures / name;
    const std::string why = rendered.picture == kept ? "" : keep(rendered.picture, kept);
    if (why.empty()) return;
    kept.clear();
    record.keeping = why;
  };
  keep_picture(povray, "povray.png", record.povray_picture);
  keep_picture(ours, "firstlight.png", record.our_picture);
}

}  // namespace

SceneRecord compare_scene(const SceneJob& given, const CompareSettings& settings) {
  SceneRecord record;
  SceneJob job = given;
  std::error_code ignored;
  job.scene = fs::absolute(job.scene, ignored);
  if (job.ini) job.ini = fs::absolute(*job.ini, ignored);
  record.name = job.name;
  record.scene = job.scene;
  const ScratchFolder scratch;
  if (!scratch.error().empty()) {
    record.message = scratch.error();
    return record;
  }
  Rendered povray;
  Rendered ours;
  render_both(job, settings, scratch, povray, ours);
  if (!stopped(settings)) fill(job, settings, povray, ours, record);
  return record;
}

std::string check_povray(const CompareSettings& settings) {
  if (find_program(settings.povray)) return {};
  if (settings.povray != CompareSettings().povray) {
    return fmt::format("there is no program '{}' to compare with", settings.povray);
  }
  return "POV-Ray is not installed, so there is nothing to compare with. Install it with: apt-get install povray "
         "povray-includes; or name its program with --povray";
}

}  // namespace firstlight::app::compare
