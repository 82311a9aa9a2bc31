#include "app/steer_server.h"

#include "app/steer_client.h"
#include "tests/app/folder.h"
#include "tests/app/steered.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <array>

namespace firstlight::app {
namespace {

/// Somebody who is connected, and waits for an answer at most ten seconds.
class Client {
 public:
  explicit Client(const std::string& path) {
    std::string error;
    socket_ = connect_to(path, error);
    EXPECT_TRUE(socket_) << error;
  }

  void send(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL);
      if (count <= 0) return;
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  void say_no_more() { ::shutdown(socket_.get(), SHUT_WR); }

  /// The next line; "(closed)" when the other end has closed, "(silence)" when nothing comes.
  std::string receive() {
    while (received_.find('\n') == std::string::npos) {
      pollfd waiting{socket_.get(), POLLIN, 0};
      if (::poll(&waiting, 1, 10'000) <= 0) return "(silence)";
      std::array<char, 65536> buffer;
      const ssize_t count = ::recv(socket_.get(), buffer.data(), buffer.size(), 0);
      if (count <= 0) return "(closed)";
      received_.append(buffer.data(), static_cast<std::size_t>(count));
    }
    const std::string line = received_.substr(0, received_.find('\n'));
    received_.erase(0, line.size() + 1);
    return line;
  }

  std::string ask(const std::string& line) {
    send(line + "\n");
    return receive();
  }

 private:
  Descriptor socket_;
  std::string received_;
};

class Server : public testing::Test {
 protected:
  void SetUp() override {
    std::string error;
    server_ = SteerServer::open(path_, error);
    ASSERT_NE(server_, nullptr) << error;
    server_->start(steered_.steering, steered_.desk);
  }

  const Folder folder_;
  const std::string path_ = folder_ / "steer";
  Steered steered_;
  std::unique_ptr<SteerServer> server_;
};

TEST_F(Server, AnswersSeveralAtOnce) {
  Client one(path_);
  Client two(path_);
  EXPECT_EQ(one.ask("scheme level"), "ok");
  EXPECT_EQ(two.ask("scheme nothing-like-it").substr(0, 6), "error ");
  EXPECT_EQ(two.ask("pause"), "ok");
  EXPECT_EQ(steered_.steering.order().text(), "level");
  EXPECT_TRUE(steered_.steering.paused());
  EXPECT_EQ(two.ask("quit"), "ok");
  EXPECT_EQ(two.receive(), "(closed)");
  EXPECT_EQ(one.ask("resume"), "ok");
}

TEST_F(Server, AnswersEachLineHoweverTheyArrive) {
  Client client(path_);
  client.send("pau");
  client.send("se\r\n\n  \nresume\nsta");
  EXPECT_EQ(client.receive(), "ok");
  EXPECT_EQ(client.receive(), "ok");
  client.send("tus");
  client.say_no_more();
  EXPECT_EQ(client.receive().substr(0, 4), "ok {");
  EXPECT_EQ(client.receive(), "(closed)");
}

TEST_F(Server, AnEndlessLineEndsTheConnectionOnly) {
  Client client(path_);
  client.send(std::string(1 << 20, 'x'));
  const std::string answer = client.receive();
  // Closing with unread data may take the message away; the end has to come in any case.
  EXPECT_TRUE(answer == "error a line has 8192 characters at most" || answer == "(closed)") << answer;
  EXPECT_EQ(Client(path_).ask("pause"), "ok");
}

TEST_F(Server, WhoVanishesOrSendsGarbageDoesNoHarm) {
  for (int i = 0; i < 50; ++i) {
    Client vanished(path_);
    vanished.send("status\nstatus\nstatus\nsta");
  }
  {
    Client garbage(path_);
    std::string bytes;
    for (int i = 0; i < 4000; ++i) bytes += static_cast<char>(i * 37 % 256);
    garbage.send(bytes + "\n");
  }
  EXPECT_EQ(Client(path_).ask("pause"), "ok");
}

TEST_F(Server, WhoDoesNotReadTheAnswersDoesNotStopTheOthers) {
  Client deaf(path_);
  std::thread flood([&] {
    std::string lines;
    for (int i = 0; i < 1000; ++i) lines += "status\n";
    for (int i = 0; i < 200; ++i) deaf.send(lines);
  });
  Client other(path_);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(other.ask("pause"), "ok");
  server_.reset();  // and the end does not wait for it
  flood.join();
}

TEST_F(Server, TakesNoMoreThanItCan) {
  std::vector<std::unique_ptr<Client>> clients;
  for (int i = 0; i < 32; ++i) {
    clients.push_back(std::make_unique<Client>(path_));
    EXPECT_EQ(clients.back()->ask("pause"), "ok");
  }
  EXPECT_EQ(Client(path_).receive(), "error too many steer this picture already");
  clients.pop_back();
  EXPECT_EQ(clients[0]->ask("resume"), "ok");
  EXPECT_EQ(Client(path_).ask("pause"), "ok");
}

TEST_F(Server, TheSocketIsItsOwnersAndGoesAtTheEnd) {
  struct stat status {};
  ASSERT_EQ(::stat(path_.c_str(), &status), 0);
  EXPECT_TRUE(S_ISSOCK(status.st_mode));
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  Client waiting(path_);
  EXPECT_EQ(waiting.ask("pause"), "ok");
  server_.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_EQ(waiting.receive(), "(closed)");
}

TEST_F(Server, ALiveSocketIsNotTakenAway) {
  std::string error;
  EXPECT_EQ(SteerServer::open(path_, error), nullptr);
  EXPECT_NE(error.find("another program listens there"), std::string::npos) << error;
  EXPECT_EQ(Client(path_).ask("pause"), "ok");
}

TEST_F(Server, HasAClientInTheProgram) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(steer_client(std::vector<std::string>{path_, "scheme", "level"}), 0);
  EXPECT_EQ(steer_client(std::vector<std::string>{path_, "scheme", "nonsense"}), 1);
  const std::string out = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(out.starts_with("ok\nerror ")) << out;
  EXPECT_EQ(steered_.steering.order().text(), "level");
}

TEST(SteerClient, SaysThatNobodyListens) {
  const Folder folder;
  for (const auto& arguments : {std::vector<std::string>{}, {folder / "nobody", "status"}}) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(steer_client(arguments), 1);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("error: "), std::string::npos);
  }
}

// ---- the socket's file -------------------------------------------------------------------------------------------

TEST(LocalSocket, AStaleOneIsReplaced) {
  const Folder folder;
  const std::string path = folder / "steer";
  std::string error;
  {
    // As a program leaves it that was killed: the file without a listener.
    std::filesystem::path moved = folder.path / "moved";
    auto first = LocalListener::open(path, error);
    ASSERT_TRUE(first) << error;
    std::filesystem::rename(path, moved);
    first.reset();
    std::filesystem::rename(moved, path);
  }
  EXPECT_FALSE(connect_to(path, error));
  EXPECT_NE(error.find("nobody listens"), std::string::npos) << error;
  const auto second = LocalListener::open(path, error);
  ASSERT_TRUE(second) << error;
  EXPECT_TRUE(connect_to(path, error)) << error;
}

TEST(LocalSocket, OtherFilesAreLeftAlone) {
  const Folder folder;
  const std::string file = folder.write("important", "text");
  std::string error;
  EXPECT_FALSE(LocalListener::open(file, error));
  EXPECT_NE(error.find("there is a file of that name"), std::string::npos) << error;
  EXPECT_EQ(text_of(file), "text");
}

TEST(LocalSocket, WhatAnotherProgramPutThereMeanwhileStays) {
  const Folder folder;
  const std::string path = folder / "steer";
  std::string error;
  auto listener = LocalListener::open(path, error);
  ASSERT_TRUE(listener) << error;
  std::filesystem::remove(path);
  folder.write("steer", "of somebody else");
  listener.reset();
  EXPECT_EQ(text_of(path), "of somebody else");
}

TEST(LocalSocket, ImpossiblePathsAreErrors) {
  const Folder folder;
  for (const std::string& path : {std::string(), folder / std::string(200, 'x'), folder / "no/such/folder/steer"}) {
    std::string error;
    EXPECT_FALSE(LocalListener::open(path, error)) << path;
    EXPECT_NE(error, "") << path;
  }
}

}  // namespace
}  // namespace firstlight::app
