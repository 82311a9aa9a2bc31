#include "app/compare/command.h"

#include "app/compare/compare_scene.h"
#include "app/compare/difference.h"
#include "app/compare/list_command.h"
#include "app/compare/options.h"
#include "app/compare/process.h"
#include "app/compare/record_json.h"
#include "app/compare/record_text.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "app/pov_switches.h"
#include "app/progress.h"
#include "render/image/image_io.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

/// `code`, or a failure when the standard output cannot be written.
int print(const std::string& text, int code) { return app::print(text, code, kExitUnreadable); }

/// Makes the folder where it is missing. Empty, or what is wrong.
std::string prepare_folder(const fs::path& folder) {
  if (folder.empty()) return {};
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fmt::format("cannot make the folder '{}': {}", folder.string(), error.message());
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return fmt::format("cannot write into the folder '{}': {}", folder.string(), std::generic_category().message(errno));
}

/// Writes difference.png and flip.png. Empty, or what is wrong.
std::string keep_maps(const fs::path& folder, const render::Picture& first, const render::Picture& second,
                      KeptMaps& kept) {
  if (folder.empty()) return {};
  const std::string map = (folder / "difference.png").string();
  const std::string flip = (folder / "flip.png").string();
  std::string why = render::write_picture(map, difference_map(first, second));
  if (why.empty()) kept.difference = map;
  if (why.empty()) why = render::write_picture(flip, flip_map(first, second));
  if (why.empty()) kept.flip = flip;
  return why;
}

std::string size_text(const render::Picture& picture) { return fmt::format("{}x{}", picture.width, picture.height); }

/// The verdict on the numbers, in a few words.
std::string verdict(const PictureDifference& difference, Status status, const Thresholds& thresholds) {
  std::string asked;
  if (thresholds.share || !thresholds.psnr) {
    asked = fmt::format("{} % of the pixels are to agree", thresholds.share.value_or(kShare));
  }
  if (thresholds.psnr) {
    asked +=
        fmt::format("{}{}", asked.empty() ? "" : " and ", fmt::format("a PSNR of {} dB is wanted", *thresholds.psnr));
  }
  switch (status) {
    case Status::agrees:
      return difference.worst == 0 ? "the pictures are equal" : "the pictures agree";
    case Status::warns:
      return fmt::format("warning: the pictures agree in the means of 8x8 pixels only ({})", asked);
    default:
      return fmt::format("the pictures differ ({})", asked);
  }
}

int compare_pictures(const CompareCommandLine& line) {
  const std::string& first = line.subjects[0];
  const std::string& second = line.subjects[1];
  KeptMaps kept;
  const auto give_up = [&](std::string_view status, const std::string& why, int code) {
    if (line.json) print(pictures_json(first, second, status, nullptr, why, kept), code);
    fail(why);
    return code;
  };
  std::string why;
  const render::Picture a = render::read_image(first, why);
  if (!why.empty()) return give_up("unreadable", why, kExitUnreadable);
  const render::Picture b = render::read_image(second, why);
  if (!why.empty()) return give_up("unreadable", why, kExitUnreadable);
  if (a.width != b.width || a.height != b.height) {
    return give_up(
        status_name(Status::other_size),
        fmt::format("the pictures have different sizes: '{}' {}, '{}' {}", first, size_text(a), second, size_text(b)),
        exit_code(Status::other_size));
  }
  const PictureDifference found = difference(a, b);
  const Status status = judge(found, line.settings.thresholds);
  if (why = prepare_folder(line.keep); why.empty()) why = keep_maps(line.keep, a, b, kept);
  if (!why.empty()) return give_up("unwritable", why, kExitUnreadable);
  if (line.json) return print(pictures_json(first, second, status_name(status), &found, "", kept), exit_code(status));
  return print(fmt::format("{}, {}: {}\n{}", first, second, verdict(found, status, line.settings.thresholds),
                           to_text(found, "in the first", "in the second")),
               exit_code(status));
}

/// The message about a scene that has no two pictures to compare; lines, the last one without its end.
std::string trouble(const SceneRecord& record) {
  const std::string& scene = record.name;
  std::string missing = to_text(record.missing);
  if (missing.ends_with('\n')) missing.pop_back();
  switch (record.status) {
    case Status::lacks_features:
      return fmt::format("{}: Firstlight cannot render what the scene asks for{}:\n{}", scene,
                         record.povray.empty() ? "" : "; POV-Ray renders it", missing);
    case Status::ours_failed:
      return fmt::format("{}: POV-Ray renders it, Firstlight does not:\n  {}", scene, record.message);
    case Status::povray_failed:
      return fmt::format("{}: Firstlight renders it, POV-Ray does not:\n  {}", scene, record.message);
    case Status::other_size:
      return fmt::format("{}: the pictures have different sizes: {}", scene, record.message);
    default:
      return fmt::format("{}: neither program renders it:\n  {}{}{}", scene, record.message,
                         missing.empty() ? "" : "\n", missing);
  }
}

std::string report(const SceneRecord& record, const CompareSettings& settings) {
  const PictureDifference& difference = *record.difference;
  return fmt::format("{}, {}x{}, {} thread{}{}: {}\n{}\n{}", record.name, difference.width, difference.height,
                     settings.threads, settings.threads == 1 ? "" : "s",
                     settings.rounds > 1 ? fmt::format(", {} rounds", settings.rounds) : "",
                     verdict(difference, record.status, settings.thresholds),
                     to_text(difference, "by POV-Ray", "by Firstlight"), times_to_text(record));
}

int compare_one_scene(CompareCommandLine& line, const std::atomic<bool>& stop) {
  SceneJob job;
  job.scene = line.subjects[0];
  job.ini = line.ini;
  job.name = line.subjects[0];
  job.pictures = line.keep;
  std::error_code ignored;
  if (!fs::exists(job.scene, ignored)) return fail(fmt::format("cannot read '{}': there is no such file", job.name));
  if (const std::string why = check_povray(line.settings); !why.empty()) return fail(why);
  line.settings.povray = find_program(line.settings.povray)->string();
  if (const std::string why = prepare_folder(line.keep); !why.empty()) return fail(why);
  ProgressLine progress(line.quiet);
  line.settings.stop = &stop;
  line.settings.say = [&](std::string_view what) { progress.stage(std::string(what)); };
  const SceneRecord record = compare_scene(job, line.settings);
  progress.clear();
  if (stop) return interrupted("");
  if (!record.keeping.empty()) return fail(record.keeping);
  KeptMaps kept;
  if (record.difference && !line.keep.empty()) {
    std::string why;
    const render::Picture theirs = render::read_image(record.povray_picture.string(), why);
    const render::Picture ours = why.empty() ? render::read_image(record.our_picture.string(), why) : render::Picture();
    if (why.empty()) why = keep_maps(line.keep, theirs, ours, kept);
    if (!why.empty()) return fail(why);
  }
  const int code = exit_code(record.status);
  if (!record.difference) say("firstlight: error: " + trouble(record));
  if (line.json) return print(scene_json(record, kept), code);
  return record.difference ? print(report(record, line.settings), code) : code;
}

}  // namespace

int fail(const std::string& why) { return app::fail(why, kExitUnreadable); }

int exit_code(Status status) {
  switch (status) {
    case Status::agrees:
      return 0;
    case Status::warns:
      return 1;
    case Status::differs:
      return 2;
    case Status::other_size:
      return 3;
    default:
      return kExitUnreadable;
  }
}

int compare_command(std::span<const std::string> arguments, const std::atomic<bool>& stop) {
  if (const auto code = compare_list_command(arguments, stop)) return *code;
  CompareCommandLine line = parse_compare_command_line(arguments);
  if (line.wish == CompareCommandLine::Wish::help) return print(compare_help_text() + list_help_text(), 0);
  for (const std::string& error : line.errors) fail(error);
  if (!line.errors.empty()) return kExitUnreadable;
  const auto is_scene = [](const std::string& name) { return lower(name).ends_with(".pov"); };
  const std::vector<std::string>& subjects = line.subjects;
  if (subjects.size() == 1 && is_scene(subjects[0])) return compare_one_scene(line, stop);
  if (subjects.size() == 2 && !is_scene(subjects[0]) && !is_scene(subjects[1])) return compare_pictures(line);
  return fail("compare: expected a scene, SCENE.pov, or two pictures; see firstlight compare --help");
}

}  // namespace firstlight::app::compare
