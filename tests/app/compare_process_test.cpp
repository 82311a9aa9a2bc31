#include "app/compare/process.h"

#include "app/compare/scratch_folder.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

Command shell(const std::string& script, const ScratchFolder& scratch, seconds limit = seconds(60)) {
  return {{"sh", "-c", script}, scratch.path(), limit, {}, nullptr};
}

/// Whether a process of that number, which a script has written to a file, is there.
bool lives(const fs::path& file) {
  std::ifstream stream(file);
  pid_t number = 0;
  stream >> number;
  for (int i = 0; number > 0 && i < 200; ++i) {
    if (kill(number, 0) != 0) return false;
    // A killed process may wait a while for the system to take note of it.
    std::ifstream status("/proc/" + std::to_string(number) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(status), {}};
    if (text.find(") Z ") != std::string::npos) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

TEST(RunProcess, TellsExitSignalAndTimeLimitApart) {
  const ScratchFolder scratch;
  const ProcessResult done = run_process(shell("echo out; echo err >&2; exit 3", scratch));
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_FALSE(done.succeeded());
  EXPECT_EQ(done.out, "out\n");
  EXPECT_EQ(done.err, "err\n");
  EXPECT_EQ(run_process(shell("kill -SEGV $$", scratch)).signal, SIGSEGV);
  const ProcessResult late = run_process(shell("sleep 100", scratch, seconds(1)));
  EXPECT_TRUE(late.timed_out);
  EXPECT_LT(late.seconds, 50);
}

TEST(RunProcess, TheLimitHoldsForWhoHasClosedItsOutputs) {
  const ScratchFolder scratch;
  const ProcessResult late = run_process(shell("exec >&- 2>&-; sleep 100", scratch, seconds(1)));
  EXPECT_TRUE(late.timed_out);
  EXPECT_LT(late.seconds, 50);
}

TEST(RunProcess, EndsWithTheProgramThoughWhatItStartedHoldsItsOutputs) {
  const ScratchFolder scratch;
  const ProcessResult done = run_process(shell("sleep 100 & echo $! > child; exit 0", scratch));
  EXPECT_TRUE(done.succeeded());
  EXPECT_LT(done.seconds, 50);
  EXPECT_FALSE(lives(scratch / "child"));
}

TEST(RunProcess, TheLimitEndsTheWholeGroup) {
  const ScratchFolder scratch;
  const ProcessResult late = run_process(shell("sleep 100 & echo $! > child; sleep 100", scratch, seconds(1)));
  EXPECT_TRUE(late.timed_out);
  EXPECT_FALSE(lives(scratch / "child"));
}

TEST(RunProcess, StopsWhenAskedTo) {
  const ScratchFolder scratch;
  std::atomic<bool> stop = false;
  Command command = shell("sleep 100", scratch);
  command.stop = &stop;
  std::thread asker([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  const ProcessResult result = run_process(command);
  asker.join();
  EXPECT_TRUE(result.stopped);
  EXPECT_FALSE(result.timed_out);
  EXPECT_LT(result.seconds, 50);
}

TEST(RunProcess, KeepsTheBeginAndTheEndOfALongOutput) {
  const ScratchFolder scratch;
  const ProcessResult result =
      run_process(shell("echo begin; head -c 40000000 /dev/zero | tr '\\0' x; echo; echo end", scratch));
  EXPECT_TRUE(result.succeeded());
  EXPECT_LT(result.out.size(), kMostOutput + 100);
  EXPECT_TRUE(result.out.starts_with("begin\n"));
  EXPECT_TRUE(result.out.ends_with("\nend\n"));
}

TEST(RunProcess, MeasuresProcessorTimeAndMemory) {
  const ScratchFolder scratch;
  const ProcessResult busy = run_process(shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done", scratch));
  EXPECT_GT(busy.processor, 0.005);
  EXPECT_GT(busy.peak_kilobytes, 100);
  EXPECT_GT(busy.seconds, 0.0);
  EXPECT_LT(run_process(shell("sleep 1", scratch)).processor, 0.9);
}

TEST(RunProcess, RunsInAFolderWithAHomeAndWithoutADisplay) {
  const ScratchFolder scratch;
  Command command = shell("pwd; echo $HOME; echo \"[$DISPLAY]\"", scratch);
  command.home = "/nowhere";
  EXPECT_EQ(run_process(command).out, scratch.path().string() + "\n/nowhere\n[]\n");
}

TEST(FindProgram, LooksWhereAShellDoes) {
  EXPECT_TRUE(find_program("sh"));
  EXPECT_EQ(find_program("/bin/sh"), fs::path("/bin/sh"));
  EXPECT_FALSE(find_program("no-such-program-anywhere"));
  EXPECT_FALSE(find_program("/etc/passwd"));
  EXPECT_FALSE(find_program("/"));
  EXPECT_FALSE(find_program(""));
}

TEST(CompareScratchFolder, IsGoneWithAllInIt) {
  fs::path path;
  {
    const ScratchFolder scratch;
    EXPECT_EQ(scratch.error(), "");
    path = scratch.path();
    std::ofstream(scratch / "file") << "text";
    EXPECT_TRUE(fs::exists(scratch / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace firstlight::app::compare
