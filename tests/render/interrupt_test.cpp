#include "render/math/interrupt.h"

#include <gtest/gtest.h>

#include <thread>

namespace firstlight::render {
namespace {

TEST(Interrupt, NobodyIsAskedToLeaveWithoutOne) {
  EXPECT_FALSE(Interrupt::asked());
  EXPECT_FALSE(Interrupt::seen());
  EXPECT_EQ(Interrupt::wish(), nullptr);
}

TEST(Interrupt, IsSeenOnlyByThoseWhoAskAfterTheWish) {
  std::atomic<bool> wish = false;
  const Interrupt interrupt(wish);
  EXPECT_FALSE(Interrupt::asked());
  wish = true;
  EXPECT_FALSE(Interrupt::seen()) << "what is computed without a question is whole";
  EXPECT_TRUE(Interrupt::asked());
  EXPECT_TRUE(Interrupt::seen());
}

TEST(Interrupt, BelongsToItsThreadAndItsScope) {
  std::atomic<bool> wish = true;
  const std::atomic<bool> other = false;
  {
    const Interrupt interrupt(wish);
    EXPECT_TRUE(Interrupt::asked());
    std::thread([] { EXPECT_FALSE(Interrupt::asked()); }).join();
    {
      const Interrupt inner(other);
      EXPECT_FALSE(Interrupt::asked() || Interrupt::seen());
    }
    EXPECT_TRUE(Interrupt::seen());
  }
  EXPECT_FALSE(Interrupt::asked() || Interrupt::seen());
}

}  // namespace
}  // namespace firstlight::render
