// How long scenes take to be read, and the memory it needs: POV-Ray and Firstlight in turn, several times over.
// POV-Ray's time is the parse time that it prints; ours is all of `firstlight --parse-only`, its start included.
// Usage: compare_parsing [--rounds 5]

#include "app/study/curve.h"
#include "tests/benchmark/paired.h"
#include "tests/golden/process.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using firstlight::golden::ProcessResult;
using firstlight::golden::ScratchFolder;

constexpr std::chrono::seconds kLimit{600};
constexpr const char* kTraceVines = "/usr/share/doc/povray/examples/language/tracevines.pov";
constexpr const char* kCamera = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -3*z }\n";

struct Subject {
  std::string name;
  fs::path scene;
  std::vector<double> povray, ours;           // seconds
  std::vector<double> povray_memory, memory;  // MB
};

std::vector<Subject> subjects(const ScratchFolder& scratch) {
  const auto scene = [&](const std::string& name, const std::string& text) {
    return scratch.write(name, kCamera + text);
  };
  return {
      {"language/tracevines.pov", kTraceVines, {}, {}, {}, {}},
      {"#while, 1,000,000 turns",
       scene("while.pov",
             "#declare I = 0;\n#declare S = 0;\n#while (I < 1000000)\n  #declare S = S + sin(I) * 2;\n"
             "  #declare I = I + 1;\n#end\nsphere { 0, 1 }\n"),
       {},
       {},
       {},
       {}},
      {"a recursive macro, 57,313 calls",
       scene("macro.pov",
             "#macro Fib(N)\n  #if (N < 2)\n    #local R = N;\n  #else\n    #local R = Fib(N - 1) + Fib(N - 2);\n"
             "  #end\n  R\n#end\n#declare F = Fib(22);\nsphere { 0, F }\n"),
       {},
       {},
       {},
       {}},
      {"200,000 spheres in a loop",
       scene("spheres.pov",
             "#declare R = seed(1);\n#for (I, 1, 200000)\n  sphere { <rand(R), rand(R), rand(R)> * 100, 0.2 "
             "pigment { color rgb <rand(R), 0.5, 1> } }\n#end\n"),
       {},
       {},
       {},
       {}},
  };
}

ProcessResult checked(const std::vector<std::string>& command, const Subject& subject, const ScratchFolder& scratch) {
  ProcessResult result = firstlight::golden::run_process(command, subject.scene.parent_path(), scratch.path(), kLimit);
  if (!result.succeeded())
    throw std::runtime_error(fmt::format("{}: {}\n{}", command[0], result.summary(), result.err));
  return result;
}

void measure(Subject& subject, const ScratchFolder& scratch) {
  const std::string file = subject.scene.filename().string();
  // A picture of one pixel, for POV-Ray always renders.
  const ProcessResult theirs =
      checked({"povray", "+I" + file, "+O" + (scratch / "picture.png").string(), "+W1", "+H1", "-A", "-D", "+WT1"},
              subject, scratch);
  subject.povray.push_back(firstlight::benchmark::povray_seconds("Parse Time:", theirs.out + theirs.err));
  subject.povray_memory.push_back(static_cast<double>(theirs.peak_kilobytes) / 1000);
  const ProcessResult ours = checked({FIRSTLIGHT_PROGRAM, file, "--parse-only", "--quiet"}, subject, scratch);
  subject.ours.push_back(ours.seconds);
  subject.memory.push_back(static_cast<double>(ours.peak_kilobytes) / 1000);
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 5;
  CLI::App app{"Times of reading scenes: POV-Ray and Firstlight, in paired rounds"};
  app.add_option("--rounds", rounds, "how often each is run")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    using firstlight::app::median;
    const ScratchFolder scratch;
    std::vector<Subject> all = subjects(scratch);
    for (int round = 0; round < rounds; ++round) {
      for (Subject& subject : all) measure(subject, scratch);
    }
    fmt::print(
        "| scene | POV-Ray, s | Firstlight, s | POV-Ray's time / this | POV-Ray, MB | Firstlight, MB |\n"
        "|---|---|---|---|---|---|\n");
    for (const Subject& subject : all) {
      fmt::print("| {} | {:.3f} | {:.3f} | {} | {:.0f} | {:.0f} |\n", subject.name, median(subject.povray),
                 median(subject.ours), firstlight::benchmark::ratio_text(subject.povray, subject.ours),
                 median(subject.povray_memory), median(subject.memory));
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "compare_parsing: {}\n", error.what());
    return 1;
  }
  return 0;
}
