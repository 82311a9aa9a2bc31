// Steering from outside: by a socket, by the standard input, by the keys of a terminal; and ends before the end.

#include "tests/golden/picture.h"
#include "tests/golden/refusal.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"
#include "tests/golden/steering_client.h"
#include "tests/golden/terminal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <future>
#include <iterator>
#include <random>
#include <thread>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const fs::path kScene = testscenes() / "full" / "mirror_room.pov";
constexpr std::chrono::seconds kSoon{30};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> command(const fs::path& picture, const std::vector<std::string>& more) {
  std::vector<std::string> words{program_under_test(), "+I" + kScene.string(), "+O" + picture.string()};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

ProcessResult run(const std::vector<std::string>& words, const ScratchFolder& scratch) {
  return run_process(words, scratch.path(), scratch.path(), kRenderLimit);
}

// ---- by a socket -------------------------------------------------------------------------------------------------

/// Something that may be asked of a picture of 400 x 300 pixels at any moment, and does not end it.
std::string random_command(std::mt19937& random) {
  const auto number = [&](unsigned below) { return static_cast<int>(random() % below); };
  switch (number(9)) {
    case 0:
      return "scheme level";
    case 1:
      return "scheme contribution";
    case 2:
      return "scheme ray-type";
    case 3:
      return fmt::format("boost light {} by {}", number(3), number(7) - 3);
    case 4:
      return fmt::format("drop light{}", number(3));
    case 5:
      return "drop all";
    case 6:
      return "pause";
    case 7:
      return "resume";
    default: {
      const int x = number(400);
      const int y = number(300);
      return fmt::format("boost region {} {} {} {} by {} as r{}", x, y, x + number(100), y + number(100), number(5) - 2,
                         number(4));
    }
  }
}

TEST(Steering, AtRandomEndsInTheSameBytes) {
  const ScratchFolder scratch;
  const std::vector<std::string> size{"+W400", "+H300", "--threads", "2"};
  ASSERT_TRUE(run(command(scratch / "calm.png", size), scratch).succeeded());
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const fs::path picture = scratch / fmt::format("steered-{}.png", seed);
    const fs::path socket = scratch / "socket";
    std::vector<std::string> words = command(picture, size);
    words.insert(words.end(), {"--steer", socket.string()});
    auto rendering = std::async(std::launch::async, [&] { return run(words, scratch); });
    int done = 0;
    {
      SteeringClient client(socket, kSoon);
      ASSERT_TRUE(client.connected());
      for (int i = 0; i < 100; ++i) {
        if (client.ask(random_command(random)).starts_with("ok")) ++done;
        std::this_thread::sleep_for(std::chrono::milliseconds(random() % 10));
      }
      client.ask("resume");
    }
    const ProcessResult result = rendering.get();
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    EXPECT_EQ(bytes_of(picture), bytes_of(scratch / "calm.png"));
    EXPECT_GT(done, 10) << "the picture was finished before it could be steered";
    EXPECT_FALSE(fs::exists(socket));
  }
}

TEST(Steering, StatusSaveAndStop) {
  const ScratchFolder scratch;
  const fs::path picture = scratch / "picture.png";
  const fs::path socket = scratch / "socket";
  auto rendering = std::async(std::launch::async, [&] {
    return run(command(picture, {"+W1280", "+H960", "--steer", socket.string(), "--stats", "stats.json"}), scratch);
  });
  {
    SteeringClient client(socket, kSoon);
    ASSERT_TRUE(client.connected());
    EXPECT_EQ(client.ask("pause"), "ok");
    const auto status = nlohmann::json::parse(client.ask("status").substr(3), nullptr, /*allow_exceptions=*/false);
    EXPECT_EQ(status.value("paused", false), true);
    EXPECT_EQ(status.value("scheme", ""), "contribution");
    EXPECT_EQ(client.ask("save " + (scratch / "now.png").string()), "ok");
    EXPECT_TRUE(client.ask("save " + (scratch / "no/such/folder.png").string()).starts_with("error "));
    EXPECT_EQ(client.ask("save"), "ok");
    const auto asked = run({program_under_test(), "steer", socket.string(), "status"}, scratch);
    EXPECT_TRUE(asked.succeeded() && asked.out.starts_with("ok {")) << asked.out << asked.err;
    EXPECT_EQ(client.ask("stop"), "ok");
  }
  const ProcessResult result = rendering.get();
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  EXPECT_NE(result.err.find("stopped by the user"), std::string::npos) << result.err;
  std::string why;
  for (const char* file : {"now.png", "picture.png"}) {
    const auto saved = read_picture(scratch / file, why);
    ASSERT_TRUE(saved) << file << ": " << why;
    EXPECT_EQ(saved->width, 1280);
  }
  const auto stats = nlohmann::json::parse(bytes_of(scratch / "stats.json"), nullptr, /*allow_exceptions=*/false);
  EXPECT_EQ(stats.at("/end/reason"_json_pointer), "stopped");
  EXPECT_GT(stats.at("/end/remaining"_json_pointer), 0.0);
}

TEST(Steering, ASocketInUseIsRefusedAndAFileIsLeftAlone) {
  const ScratchFolder scratch;
  const fs::path file = scratch.write("notes.txt", "text");
  const fs::path picture = scratch / "picture.png";
  for (const fs::path& socket : {file, scratch / "no" / "such", scratch / std::string(200, 'x')}) {
    expect_command_refused({"+I" + kScene.string(), "+O" + picture.string(), "--steer", socket.string()}, picture,
                           scratch);
  }
  EXPECT_EQ(bytes_of(file), "text");
}

// ---- by the standard input ---------------------------------------------------------------------------------------

TEST(Steering, ByTheStandardInput) {
  const ScratchFolder scratch;
  const std::string line =
      fmt::format("printf 'scheme level\\nnonsense\\nstatus\\nstop' | '{}' '+I{}' +Opicture.png +W1280 +H960 --steer -",
                  program_under_test(), kScene.string());
  const ProcessResult result = run({"sh", "-c", line}, scratch);
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  const auto answers = lines_of(result.out);
  ASSERT_EQ(answers.size(), 4u) << result.out;
  EXPECT_EQ(answers[0], "ok");
  EXPECT_TRUE(answers[1].starts_with("error "));
  EXPECT_TRUE(answers[2].starts_with("ok {"));
  EXPECT_EQ(answers[3], "ok");
  EXPECT_NE(result.err.find("stopped by the user"), std::string::npos) << result.err;
}

TEST(Steering, TheEndOfTheStandardInputIsNotTheEndOfThePicture) {
  const ScratchFolder scratch;
  const ProcessResult result = run(command(scratch / "picture.png", {"+W40", "+H30", "--steer", "-"}), scratch);
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  EXPECT_EQ(result.err.find("stopped"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(scratch / "picture.png"));
}

// ---- by keys -----------------------------------------------------------------------------------------------------

TEST(TerminalKeys, PauseSaveAndStop) {
  const ScratchFolder scratch;
  Terminal terminal(command(scratch / "picture.png", {"+W1280", "+H960"}), scratch.path());
  ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
  EXPECT_FALSE(terminal.is_ordinary());
  terminal.type(" ");
  ASSERT_TRUE(terminal.wait_for("paused at", kSoon)) << terminal.text();
  terminal.type("l");
  ASSERT_TRUE(terminal.wait_for("scheme level", kSoon)) << terminal.text();
  terminal.type("\x1b[A~Z?");  // an arrow, and keys that mean nothing
  terminal.type("?");
  ASSERT_TRUE(terminal.wait_for("pause, continue", kSoon)) << terminal.text();
  terminal.type("s");
  ASSERT_TRUE(terminal.wait_for("saved", kSoon)) << terminal.text();
  EXPECT_TRUE(fs::exists(scratch / "picture.png"));
  terminal.type("q");
  EXPECT_EQ(terminal.wait_for_end(kSoon), 0) << terminal.text();
  EXPECT_TRUE(terminal.wait_for("stopped by the user", kSoon)) << terminal.text();
  EXPECT_TRUE(terminal.is_ordinary());
}

TEST(TerminalKeys, TheTerminalIsGivenBackHoweverTheProgramEnds) {
  const ScratchFolder scratch;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGSEGV, SIGABRT}) {
    SCOPED_TRACE(signal);
    Terminal terminal(command(scratch / "picture.png", {"+W1280", "+H960"}), scratch.path());
    ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
    EXPECT_FALSE(terminal.is_ordinary());
    terminal.signal(signal);
    const int code = terminal.wait_for_end(kSoon);
    EXPECT_EQ(code, signal == SIGINT || signal == SIGTERM || signal == SIGHUP ? 130 : -1) << terminal.text();
    EXPECT_TRUE(terminal.is_ordinary());
    EXPECT_FALSE(fs::exists(scratch / "picture.png"));
  }
}

TEST(TerminalKeys, CtrlCEndsAPausedPicture) {
  const ScratchFolder scratch;
  Terminal terminal(command(scratch / "picture.png", {"+W1280", "+H960"}), scratch.path());
  ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
  terminal.type(" ");
  ASSERT_TRUE(terminal.wait_for("paused at", kSoon)) << terminal.text();
  terminal.type("\x03");
  EXPECT_EQ(terminal.wait_for_end(kSoon), 130) << terminal.text();
  EXPECT_TRUE(terminal.is_ordinary());
  EXPECT_FALSE(fs::exists(scratch / "picture.png"));
}

TEST(TerminalKeys, TheTerminalIsGivenBackWhileTheProgramIsStopped) {
  const ScratchFolder scratch;
  // A shell between, as on a real terminal: it alone may let a program rest.
  Terminal terminal(
      {"sh", "-c",
       fmt::format("set -m; '{}' '+I{}' +Opicture.png +W2560 +H1920; echo RESTS; stty -a | tr ';' '\\n' | "
                   "grep -ow -e '-*icanon'; fg; echo ENDED $?",
                   program_under_test(), kScene.string())},
      scratch.path());
  ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
  terminal.type("\x1a");
  ASSERT_TRUE(terminal.wait_for("RESTS", kSoon)) << terminal.text();
  ASSERT_TRUE(terminal.wait_for("icanon", kSoon)) << terminal.text();
  EXPECT_EQ(terminal.text().find("-icanon"), std::string::npos);
  ASSERT_TRUE(terminal.wait_for("? for keys", kSoon)) << terminal.text();
  std::this_thread::sleep_for(600ms);
  EXPECT_FALSE(terminal.is_ordinary());
  terminal.type("q");
  EXPECT_TRUE(terminal.wait_for("ENDED 0", kSoon)) << terminal.text();
  EXPECT_TRUE(terminal.is_ordinary());
}

// ---- ends before the end -----------------------------------------------------------------------------------------

nlohmann::json stats_of(const std::vector<std::string>& options, const ScratchFolder& scratch, std::string& err) {
  std::vector<std::string> words = command(scratch / "picture.png", {"--stats", "stats.json"});
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run(words, scratch);
  EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
  std::string why;
  EXPECT_TRUE(read_picture(scratch / "picture.png", why)) << why;
  err = result.err;
  return nlohmann::json::parse(bytes_of(scratch / "stats.json"), nullptr, /*allow_exceptions=*/false);
}

TEST(Ends, AfterATime) {
  const ScratchFolder scratch;
  std::string err;
  const auto stats = stats_of({"+W1600", "+H1200", "--stop-after", "0.5"}, scratch, err);
  EXPECT_EQ(stats.at("/end/reason"_json_pointer), "time-over");
  EXPECT_GT(stats.at("/end/remaining"_json_pointer), 0.0);
  EXPECT_LT(stats.at("/time/trace_s"_json_pointer), 5.0);
  EXPECT_NE(err.find("stopped after 0.5 s, at most "), std::string::npos) << err;
}

TEST(Ends, AtAnError) {
  const ScratchFolder scratch;
  std::string err;
  const auto stats = stats_of({"+W400", "+H300", "--stop-at-error", "0.3"}, scratch, err);
  EXPECT_EQ(stats.at("/end/reason"_json_pointer), "error-reached");
  EXPECT_GT(stats.at("/end/remaining"_json_pointer), 0.0);
  EXPECT_LE(stats.at("/end/remaining"_json_pointer), 0.3);
  EXPECT_NE(err.find("stopped at an error of 0.3 or less, at most "), std::string::npos) << err;
}

TEST(Ends, CtrlCLeavesNoPictureAndNoSocket) {
  const ScratchFolder scratch;
  std::vector<std::string> words{"timeout", "--preserve-status", "-s", "INT", "1"};
  for (const std::string& word : command(scratch / "picture.png", {"+W3200", "+H2400", "--steer", "socket"})) {
    words.push_back(word);
  }
  const ProcessResult result = run(words, scratch);
  EXPECT_EQ(result.exit_code, 130) << result.summary() << '\n' << result.err;
  EXPECT_NE(result.err.find("no picture written"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace firstlight::golden
