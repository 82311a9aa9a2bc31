#include "app/steer_commands.h"

#include "tests/app/steered.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <random>

namespace firstlight::app {
namespace {

TEST(SteerCommands, ChangeTheScheme) {
  Steered steered;
  const auto version = steered.steering.version();
  EXPECT_EQ(steered.answer("scheme level"), "ok");
  EXPECT_EQ(steered.steering.order().text(), "level");
  EXPECT_GT(steered.steering.version(), version);
  EXPECT_TRUE(steered.answer("scheme levle").starts_with("error "));
  EXPECT_EQ(steered.answer("scheme levle").find('\n'), std::string::npos);
  EXPECT_EQ(steered.answer("scheme"), "error expected scheme TEXT");
  EXPECT_EQ(steered.steering.order().text(), "level");
}

TEST(SteerCommands, AddAndDropBoosts) {
  Steered steered;
  EXPECT_EQ(steered.answer("boost region 10 10 50 50 by 2 as face"), "ok face: region 10 10 50 50 by 2");
  EXPECT_EQ(steered.answer("boost light 1"), "ok light1: light 1 by 1");
  ASSERT_EQ(steered.steering.order().boosts().size(), 2u);
  EXPECT_EQ(steered.steering.order().boosts()[0].region.right, 50);
  EXPECT_EQ(steered.answer("drop face"), "ok");
  EXPECT_EQ(steered.answer("drop face"), "error there is no boost 'face'");
  EXPECT_EQ(steered.answer("boost light 0"), "ok light0: light 0 by 1");
  EXPECT_EQ(steered.answer("drop all"), "ok");
  EXPECT_TRUE(steered.steering.order().boosts().empty());
}

TEST(SteerCommands, BoostsThatTheSceneDoesNotKnowAreRefused) {
  Steered steered;
  for (const char* line : {"boost light 2", "boost light -1", "boost object Nobody", "boost region 9 9 1 1",
                           "boost region 5000 0 5001 1", "boost", "boost place", "drop", "drop nothing"}) {
    EXPECT_TRUE(steered.answer(line).starts_with("error ")) << line;
  }
  EXPECT_TRUE(steered.steering.order().boosts().empty());
}

TEST(SteerCommands, PauseResumeAndStop) {
  Steered steered;
  EXPECT_EQ(steered.answer("pause"), "ok");
  EXPECT_TRUE(steered.steering.paused());
  EXPECT_EQ(steered.answer("resume"), "ok");
  EXPECT_FALSE(steered.steering.paused());
  EXPECT_EQ(steered.answer("stop"), "ok");
  EXPECT_TRUE(steered.steering.stopped());
}

TEST(SteerCommands, StatusIsOneLineOfJson) {
  Steered steered;
  priority::Progress progress;
  progress.traced.of(render::RayKind::shadow) = 7;
  progress.rays_waiting = 5;
  progress.queue_bytes = 320;
  progress.seconds = 1.5;
  progress.remaining = 0.25;
  steered.desk.progress(progress);
  steered.answer("pause");
  steered.answer("boost region 1 2 3 4 as face");
  const std::string answer = steered.answer("status");
  ASSERT_TRUE(answer.starts_with("ok {")) << answer;
  EXPECT_EQ(answer.find('\n'), std::string::npos);
  const auto json = nlohmann::json::parse(answer.substr(3));
  EXPECT_EQ(json["rays"]["shadow"], 7);
  EXPECT_EQ(json["rays"]["primary"], 0);
  EXPECT_EQ(json["waiting"], 5);
  EXPECT_EQ(json["bytes"], 320);
  EXPECT_EQ(json["seconds"], 1.5);
  EXPECT_EQ(json["remaining"], 0.25);
  EXPECT_EQ(json["remaining_is_bound"], true);
  EXPECT_EQ(json["scheme"], "contribution");
  EXPECT_EQ(json["paused"], true);
  EXPECT_EQ(json["boosts"][0]["name"], "face");
  EXPECT_EQ(json["boosts"][0]["region"], (std::vector<int>{1, 2, 3, 4}));
}

TEST(SteerCommands, SaveAnswersWhenThePictureIsWritten) {
  Steered steered;
  std::vector<std::string> files;
  const auto write = [&](const std::string& file) -> std::string {
    files.push_back(file);
    return file == "bad.png" ? "the disk is full" : "";
  };
  while_served(steered, write, [&] {
    EXPECT_EQ(steered.answer("save"), "ok");
    EXPECT_EQ(steered.answer("save my picture.png"), "ok");
    EXPECT_EQ(steered.answer("save bad.png"), "error the disk is full");
  });
  EXPECT_EQ(files, (std::vector<std::string>{"", "my picture.png", "bad.png"}));
}

TEST(SteerCommands, NobodyWaitsForAPictureThatWillNotCome) {
  Steered steered;
  std::thread late([&] { EXPECT_EQ(steered.answer("save"), "error the rendering has ended"); });
  steered.desk.close();
  late.join();
  EXPECT_EQ(steered.answer("save"), "error the rendering has ended");
}

TEST(SteerCommands, HelpNamesAllAndQuitSaysGoodbye) {
  Steered steered;
  for (const char* name : {"scheme", "boost", "drop", "pause", "resume", "stop", "save", "status", "help", "quit"}) {
    EXPECT_NE(steered.answer("help").find(name), std::string::npos) << name;
  }
  EXPECT_FALSE(steered.commands.answer("help").goodbye);
  EXPECT_TRUE(steered.commands.answer(" quit ").goodbye);
}

TEST(SteerCommands, UnknownOnesAreAnsweredWithTheNearest) {
  Steered steered;
  EXPECT_EQ(steered.answer("shceme level"), "error there is no command 'shceme'; the nearest is 'scheme'");
  EXPECT_EQ(steered.answer("xyzzy"), "error there is no command 'xyzzy'; help lists all");
  EXPECT_EQ(steered.answer("pause now"), "error expected nothing after 'pause', found 'now'");
  EXPECT_EQ(steered.answer("\x80\xff\x1b[2J"), "error there is no such command; help lists all");
  EXPECT_EQ(steered.answer(""), "");
  EXPECT_EQ(steered.answer(" \t\r"), "");
}

TEST(SteerCommands, AnswerAnythingInOneLine) {
  Steered steered;
  std::mt19937 random(7);
  const std::vector<std::string> words{"scheme", "boost",  "region", "object", "light", "by", "as", "drop",
                                       "status", "level,", "(",      "1e999",  "-1",    "0",  "%n", "\x1b[2J"};
  for (int i = 0; i < 2000; ++i) {
    std::string line;
    for (unsigned count = random() % 8; count > 0; --count) {
      line += words[random() % words.size()];
      line += static_cast<char>(random() % 4 == 0 ? random() % 256 : ' ');
    }
    std::erase(line, '\n');
    const std::string answer = steered.answer(line);
    EXPECT_TRUE(answer.empty() || answer.starts_with("ok") || answer.starts_with("error ")) << line;
    EXPECT_TRUE(std::none_of(answer.begin(), answer.end(), [](unsigned char c) { return c < ' '; })) << line;
  }
}

}  // namespace
}  // namespace firstlight::app
