#include "render/texture/finish.h"

#include <gtest/gtest.h>

namespace firstlight::render {
namespace {

// POV-Ray 3.7 takes a finish to be this when the scene says nothing.
TEST(Finish, DefaultsAreThoseOfTheLanguage) {
  const Finish finish;
  EXPECT_EQ(finish.ambient, Rgb(0.1f));
  EXPECT_EQ(finish.emission, Rgb(0.0f));
  EXPECT_EQ(finish.diffuse, 0.6);
  EXPECT_EQ(finish.diffuse_back, 0.0);
  EXPECT_EQ(finish.brilliance, 1.0);
  EXPECT_EQ(finish.phong, 0.0);
  EXPECT_EQ(finish.phong_size, 40.0);
  EXPECT_EQ(finish.specular, 0.0);
  EXPECT_EQ(finish.roughness_exponent, 1.0 / 0.05);
  EXPECT_EQ(finish.metallic, 0.0);
  EXPECT_EQ(finish.reflection_max, Rgb(0.0f));
  EXPECT_EQ(finish.reflection_falloff, 1.0);
  EXPECT_EQ(finish.reflection_exponent, 1.0);
  EXPECT_FALSE(finish.reflection_fresnel);
  EXPECT_FALSE(finish.conserve_energy);
}

}  // namespace
}  // namespace firstlight::render
