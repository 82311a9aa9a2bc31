// Renders scenes that nobody wrote with POV-Ray and with Firstlight, at length and by hand, and tells which disagree:
//
//     firstlight_random_scenes --first 0 --count 1000
//     firstlight_random_scenes --ties --count 696
//     firstlight_random_scenes --first 17 --print > scene.pov

#include "app/compare/compare_scene.h"
#include "app/compare/record_text.h"
#include "tests/golden/random_scene.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>

namespace firstlight::golden {
namespace {

/// Compares one scene and says in a line where its pictures differ; empty where they agree in at least `share` of 100
/// pixels.
std::string disagreement(const std::string& text, double share) {
  const ScratchFolder scratch;
  app::compare::SceneJob job;
  job.scene = scratch.write("scene.pov", text);
  job.name = "scene";
  app::compare::CompareSettings settings;
  settings.width = 120;
  settings.height = 90;
  settings.firstlight = program_under_test();
  settings.thresholds.share = share;
  const app::compare::SceneRecord record = app::compare::compare_scene(job, settings);
  if (record.status == app::compare::Status::agrees) return "";
  return record.difference ? summary(*record.difference) : record.message;
}

int run(int argc, char** argv) {
  CLI::App app("Compares random scenes with POV-Ray; prints the numbers of those that disagree.");
  std::uint64_t first = 0;
  std::uint64_t count = 1;
  double share = 98;
  bool ties = false;
  bool print = false;
  app.add_option("--first", first, "the first seed");
  app.add_option("--count", count, "how many");
  app.add_option("--share", share, "how many of 100 pixels must agree");
  app.add_flag("--ties", ties, "things in one place, instead of combinations");
  app.add_flag("--print", print, "only print the scenes");
  CLI11_PARSE(app, argc, argv);
  std::uint64_t apart = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string text = ties ? tie_scene(seed) : random_csg_scene(seed);
    if (print) {
      fmt::print("{}", text);
      continue;
    }
    const std::string found = disagreement(text, share);
    if (found.empty()) continue;
    ++apart;
    fmt::print("{}: {}\n", seed, found);
    std::fflush(stdout);
  }
  if (!print) fmt::print("{} of {} scenes disagree\n", apart, count);
  return apart == 0 ? 0 : 1;
}

}  // namespace
}  // namespace firstlight::golden

int main(int argc, char** argv) { return firstlight::golden::run(argc, argv); }
