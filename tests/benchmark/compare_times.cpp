// How long a scene takes in each order: POV-Ray, the traditional order, and each scheme, in turn, several times over;
// `firstlight compare --rounds` knows two programs only.
//
// Comparisons are paired: every round runs all orders one after the other, and a ratio is taken within its round, so
// that a machine that is slower for a minute is slower for all. Reported are medians, and the range of each ratio.
// Usage: compare_times [--size 1024] [--rounds 7] [--threads 1] [--scene FILE.pov] [--without-povray]

#include "app/compare/programs.h"
#include "app/compare/record_text.h"
#include "app/compare/scratch_folder.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace firstlight::app::compare;

constexpr std::chrono::seconds kLimit{3600};
const std::vector<std::string> kSchemes{"recursive", "contribution", "level", "ray-type"};

struct Settings {
  fs::path scene = fs::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes" / "full" / "mirror_room.pov";
  int size = 1024;
  int rounds = 7;
  int threads = 1;
  bool with_povray = true;
};

/// One run: seconds of tracing, without reading the scene; and what `--stats` said, if it was ours.
struct Run {
  double trace_s = 0;
  nlohmann::json stats;
};

double checked(const std::string& program, const SceneRun& run) {
  if (!run.error.empty()) throw std::runtime_error(fmt::format("{}: {}", program, run.error));
  return run.times.trace;
}

CompareSettings compare_settings(const Settings& settings) {
  CompareSettings out;
  out.width = out.height = settings.size;
  out.threads = settings.threads;
  out.time_limit = kLimit;
  out.firstlight = FIRSTLIGHT_PROGRAM;
  return out;
}

SceneJob job_of(const Settings& settings) {
  return {settings.scene, {}, settings.scene.filename().string(), {}, nullptr};
}

Run measure_povray(const Settings& settings, const ScratchFolder& scratch) {
  return {checked("povray", run_povray(job_of(settings), compare_settings(settings), scratch / "povray.png")), {}};
}

Run measure_firstlight(const std::string& scheme, const Settings& settings, const ScratchFolder& scratch) {
  CompareSettings own = compare_settings(settings);
  own.our_words = {"--scheme=" + scheme};
  Run measured;
  measured.trace_s = checked(scheme, run_firstlight(job_of(settings), own, scratch / "firstlight.png"));
  std::ifstream stream(scratch / "firstlight.png.json");
  measured.stats = nlohmann::json::parse(stream);
  return measured;
}

using Table = std::map<std::string, std::vector<Run>>;

Table measure(const Settings& settings) {
  const ScratchFolder scratch;
  Table table;
  for (int round = 0; round < settings.rounds; ++round) {
    fmt::print("round {} of {}:", round + 1, settings.rounds);
    const auto note = [&](const std::string& name, Run measured) {
      fmt::print(" {} {:.2f} s", name, measured.trace_s);
      std::fflush(stdout);
      table[name].push_back(std::move(measured));
    };
    if (settings.with_povray) note("povray", measure_povray(settings, scratch));
    // Each round begins with another scheme, so that none always follows the same one.
    for (std::size_t i = 0; i < kSchemes.size(); ++i) {
      const std::string& scheme = kSchemes[(i + static_cast<std::size_t>(round)) % kSchemes.size()];
      note(scheme, measure_firstlight(scheme, settings, scratch));
    }
    fmt::print("\n");
  }
  return table;
}

double median(const std::vector<double>& values) { return spread_of(values).median; }

std::vector<double> trace_times(const std::vector<Run>& runs) {
  std::vector<double> times;
  for (const Run& measured : runs) times.push_back(measured.trace_s);
  return times;
}

/// "8.20 (7.9 to 8.6)": the median and the range of above/below, taken round by round; "" without `above`.
std::string ratio(const Table& table, const std::string& above, const std::string& below) {
  const auto over = table.find(above);
  if (over == table.end()) return "";
  std::vector<double> ratios;
  for (std::size_t i = 0; i < over->second.size(); ++i) {
    ratios.push_back(over->second[i].trace_s / table.at(below)[i].trace_s);
  }
  const Spread spread = spread_of(ratios);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", spread.median, spread.least, spread.most);
}

void report(const Table& table, const Settings& settings) {
  fmt::print("\n{} at {}x{}, {} thread(s), {} rounds; medians, ratios paired within a round\n\n",
             settings.scene.filename().string(), settings.size, settings.size, settings.threads, settings.rounds);
  fmt::print(
      "| order | trace, s | build, s | first image, s | rays | million rays a second | peak queue, MB | "
      "POV-Ray's time / this | this / recursive |\n|---|---|---|---|---|---|---|---|---|\n");
  if (const auto povray = table.find("povray"); povray != table.end()) {
    fmt::print("| POV-Ray | {:.2f} | | | | | | 1 | |\n", median(trace_times(povray->second)));
  }
  for (const std::string& scheme : kSchemes) {
    const std::vector<Run>& runs = table.at(scheme);
    const auto median_of = [&](const char* path) {
      std::vector<double> values;
      for (const Run& measured : runs) values.push_back(measured.stats.at(nlohmann::json::json_pointer(path)));
      return median(values);
    };
    double rays = 0;
    for (const auto& [kind, count] : runs.front().stats.at("rays").items()) rays += count.get<double>();
    const double time = median(trace_times(runs));
    fmt::print("| {} | {:.2f} | {:.3f} | {:.2f} | {:.0f} | {:.2f} | {:.1f} | {} | {} |\n", scheme, time,
               median_of("/time/build_s"), median_of("/time/first_image_s"), rays, rays / time / 1e6,
               median_of("/queue/peak_bytes") / 1e6, ratio(table, "povray", scheme), ratio(table, scheme, "recursive"));
  }
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  std::string scene = settings.scene.string();
  bool without_povray = false;
  CLI::App app{"Times of a scene: POV-Ray, the traditional order and each scheme, in paired rounds"};
  app.add_option("--scene", scene, "the scene to render")->check(CLI::ExistingFile);
  app.add_option("--size", settings.size, "width and height in pixels")->check(CLI::PositiveNumber);
  app.add_option("--rounds", settings.rounds, "how often each is run")->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads, "threads of each program")->check(CLI::PositiveNumber);
  app.add_flag("--without-povray", without_povray, "compare the schemes only");
  CLI11_PARSE(app, argc, argv);
  settings.scene = fs::absolute(scene);
  settings.with_povray = !without_povray;
  try {
    report(measure(settings), settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare_times: {}\n", error.what());
    return 1;
  }
  return 0;
}
