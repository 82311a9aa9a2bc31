#include "render/math/interrupt.h"

#include "tests/render/random_scene.h"

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

TEST(Interrupt, EndsTheBuildingOfATree) {
  const RandomScene random(1, Fancy::plausible);
  const std::atomic<bool> wish = true;
  const Interrupt interrupt(wish);
  const Accel accel(random.scene());
  EXPECT_TRUE(Interrupt::seen());
  const RayQuery query{{Vec3(0.0, 0.0, -5.0), Vec3(0.0, 0.0, 1.0)}, 0.0, 1e9, 0};
  Hit hit;
  accel.closest({&query, 1}, {&hit, 1});  // of no use, but no harm
}

}  // namespace
}  // namespace firstlight::render
