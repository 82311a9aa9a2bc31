#include "app/process_start.h"

#include <gtest/gtest.h>

#include <thread>

namespace firstlight::app {
namespace {

TEST(ProcessStart, IsThePastAndStays) {
  using std::chrono::milliseconds;
  const auto before = std::chrono::steady_clock::now();
  const auto first = process_start();
  std::this_thread::sleep_for(milliseconds(30));
  const auto second = process_start();
  EXPECT_LE(first, before);
  EXPECT_LT(before - first, std::chrono::minutes(10));
  EXPECT_LT(std::chrono::abs(second - first), milliseconds(11));
}

}  // namespace
}  // namespace firstlight::app
