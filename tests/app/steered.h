#pragma once

#include "app/desk.h"
#include "app/steer_commands.h"
#include "priority/steering.h"
#include "render/scene/scene.h"
#include "render/scene/scene_index.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>

namespace firstlight::app {

/// Everything that those who steer a picture meet, but nobody renders it.
struct Steered {
  Steered()
      : steering(order_of("contribution")),
        desk(steering, [this](const std::string& file) { return write(file); }),
        commands(steering, desk) {}

  priority::Order order_of(const std::string& text) {
    scene.lights.resize(2);
    std::string error;
    auto order = priority::Order::parse(text, {index_of(scene), 320, 240}, error);
    EXPECT_TRUE(order) << error;
    return std::move(*order);
  }

  std::string answer(const std::string& line) { return commands.answer(line).text; }

  render::Scene scene;
  priority::Steering steering;
  Desk::Write write;  ///< of while_served()
  Desk desk;
  SteerCommands commands;
};

/// Runs `what` while another thread does what the one that renders does with wishes to save.
inline void while_served(Steered& steered, const Desk::Write& write, const std::function<void()>& what) {
  steered.write = write;
  std::atomic<bool> over = false;
  std::thread renderer([&] {
    while (!over) {
      if (steered.steering.take_save_request()) steered.desk.serve();
      std::this_thread::yield();
    }
  });
  what();
  over = true;
  renderer.join();
}

}  // namespace firstlight::app
