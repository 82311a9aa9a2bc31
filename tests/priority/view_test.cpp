#include "priority/driver.h"
#include "tests/priority/small_scenes.h"

#include <gtest/gtest.h>

namespace firstlight::priority {
namespace {

TEST(View, AnotherCameraNeedsNoOtherScene) {
  SmallScene scene = hall_of_mirrors();
  SmallScene other = hall_through_a_fisheye();
  render::TraceContext context = scene.context();
  context.other_camera = &other.scene().camera;
  render::Film film(40, 30);
  render::Film expected(40, 30);
  ASSERT_TRUE(trace(context, film, {}).complete());
  ASSERT_TRUE(trace(other.context(), expected, {}).complete());
  EXPECT_EQ(film.snapshot(), expected.snapshot());
}

}  // namespace
}  // namespace firstlight::priority
