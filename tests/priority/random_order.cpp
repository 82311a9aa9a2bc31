#include "tests/priority/random_order.h"

#include "priority/schemes.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <vector>

namespace firstlight::priority {
namespace {

int below(std::mt19937& random, int count) { return static_cast<int>(random() % static_cast<std::uint32_t>(count)); }

std::string random_criterion(std::mt19937& random) {
  static const std::vector<std::string> kCriteria = [] {
    std::vector<std::string> all{"ray-type(shadow reflection transmission primary)", "object(Glass Floor)",
                                 "region(3,4,12,20 14,5,30,9)", "light(1 0)"};
    for (const SchemeRow& row : schemes()) {
      const bool needs_a_compiler = row.name == "expr";
      if (row.make != nullptr && !needs_a_compiler) all.emplace_back(row.example);
    }
    return all;
  }();
  return kCriteria[random() % kCriteria.size()];
}

Boost random_boost(std::mt19937& random) {
  Boost boost;
  boost.name = fmt::format("boost{}", below(random, 4));
  boost.kind = static_cast<Boost::Kind>(below(random, 3));
  const int left = below(random, 15);
  const int top = below(random, 12);
  boost.region = {left, top, left + below(random, 10), top + below(random, 10)};
  boost.object = below(random, 2) == 0 ? "Ball" : "Floor";
  boost.light = below(random, 2);
  boost.by = below(random, 7) - 3;
  return boost;
}

}  // namespace

std::string random_order(std::mt19937& random) {
  std::string text = random_criterion(random);
  for (int more = below(random, 4); more > 0; --more) {
    switch (below(random, 3)) {
      case 0:
        text += ", " + random_criterion(random);
        break;
      case 1:
        text += fmt::format(" + {}*{}", 0.25 * (1 + below(random, 8)), random_criterion(random));
        break;
      default:
        text = fmt::format("({}) - {}", text, random_criterion(random));
    }
  }
  return text;
}

int steer_at_random(Steering& steering, std::mt19937& random, const std::atomic<bool>& done) {
  int refused = 0;
  const auto expect_accepted = [&refused](const std::string& problem) { refused += problem.empty() ? 0 : 1; };
  constexpr int kMost = 40;  // where everything is slow, steering must leave time for tracing
  for (int i = 0; i < kMost && !done.load(); ++i) {
    std::this_thread::sleep_for(std::chrono::microseconds(below(random, 400)));
    switch (below(random, 8)) {
      case 0:
      case 1:
        expect_accepted(steering.set_scheme(random_order(random)));
        break;
      case 2:
      case 3:
        expect_accepted(steering.boost(random_boost(random)));
        break;
      case 4:
        steering.drop(fmt::format("boost{}", below(random, 4)));
        break;
      case 5:
        steering.drop_all();
        break;
      case 6:
        steering.pause();
        std::this_thread::sleep_for(std::chrono::microseconds(below(random, 300)));
        steering.resume();
        break;
      default:
        steering.save();
    }
  }
  return refused;
}

}  // namespace firstlight::priority
