#include "render/texture/image_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace firstlight::render {
namespace {

/// Two pixels wide, two high; rows from the top: 10 20 / 30 40 of 100.
std::shared_ptr<ImageUse> small_picture() {
  Raster raster;
  raster.width = raster.height = 2;
  raster.channels = 1;
  raster.white = 100;
  raster.samples = Raster::Bytes{10, 20, 30, 40};
  auto use = std::make_shared<ImageUse>();
  use->source.image = std::make_shared<const Image>(raster, Transcoding(), ImageKind());
  return use;
}

float red_at(const ImageMap& map, const Vec3& point) { return map.at(*map.place(point)).color.rgb.x; }

TEST(ImageMap, RowsGoDownWhereYGoesUp) {
  const ImageMap map(small_picture());
  EXPECT_FLOAT_EQ(red_at(map, {0.25, 0.25, 7.0}), 0.3f);
  EXPECT_FLOAT_EQ(red_at(map, {0.75, 0.75, 0.0}), 0.2f);
}

TEST(ImageMap, RepeatsUnlessLaidOnce) {
  const auto use = small_picture();
  EXPECT_FLOAT_EQ(red_at(ImageMap(use), {-0.25, 3.75, 0.0}), 0.2f);
  use->once = true;
  EXPECT_FALSE(ImageMap(use).place({-0.25, 0.5, 0.0}));
  EXPECT_TRUE(ImageMap(use).place({0.25, 0.5, 0.0}));
  EXPECT_TRUE(ImageMap(use).lets_light_through());
}

TEST(ImageMap, BlendsNeighbours) {
  const auto use = small_picture();
  use->interpolation = ImageUse::Interpolation::bilinear;
  EXPECT_NEAR(red_at(ImageMap(use), {0.5, 0.5, 0.0}), 0.25, 1e-6);
  use->interpolation = ImageUse::Interpolation::bicubic;
  EXPECT_NEAR(red_at(ImageMap(use), {0.5, 0.5, 0.0}), 0.25, 1e-6);
}

TEST(ImageMap, AnywhereIsInThePicture) {
  const auto use = small_picture();
  for (const auto projection : {ImageUse::Projection::planar, ImageUse::Projection::spherical,
                                ImageUse::Projection::cylindrical, ImageUse::Projection::torus}) {
    use->projection = projection;
    const ImageMap map(use);
    for (const double far : {0.0, 1.0, -1e17, 1e300, static_cast<double>(NAN)}) {
      const auto place = map.place({far, 1.0, -far});
      if (!place) continue;
      EXPECT_GE(place->x, 0.0);
      EXPECT_LT(place->x, 2.0);
      EXPECT_GE(place->y, 0.0);
      EXPECT_LT(place->y, 2.0);
    }
  }
}

TEST(ImageMap, EntriesOfAPaletteLetLightThrough) {
  Raster raster;
  raster.width = 2;
  raster.height = 1;
  raster.channels = 1;
  raster.samples = Raster::Bytes{0, 1};
  raster.palette = {{255, 0, 0, 255}, {0, 0, 255, 255}};
  ImageUse use;
  use.source.image = std::make_shared<const Image>(raster, Transcoding(), ImageKind());
  EXPECT_FALSE(ImageMap(std::make_shared<const ImageUse>(use)).lets_light_through());
  use.transmits = {{1, 0.5}};
  const ImageMap map(std::make_shared<const ImageUse>(use));
  EXPECT_TRUE(map.lets_light_through());
  EXPECT_FLOAT_EQ(map.at(*map.place({0.25, 0.5, 0.0})).color.transmit, 0.0f);
  EXPECT_FLOAT_EQ(map.at(*map.place({0.75, 0.5, 0.0})).color.transmit, 0.5f);
  EXPECT_EQ(map.at(*map.place({0.75, 0.5, 0.0})).index, 1);
}

TEST(TransferCurve, FilesAreTurnedIntoTheNumbersOfTheScene) {
  const TransferCurve srgb{TransferCurve::Kind::srgb};
  EXPECT_FLOAT_EQ(Transcoding(srgb, {})(0.5f), 0.21404114f);
  EXPECT_EQ(Transcoding(srgb, srgb)(0.5f), 0.5f);
  EXPECT_FLOAT_EQ(Transcoding(TransferCurve::of_power(2.0), {})(0.5f), 0.25f);
  EXPECT_FLOAT_EQ(Transcoding(TransferCurve::of_power(2.0), TransferCurve::of_power(4.0))(0.25f), 0.5f);
  EXPECT_TRUE(TransferCurve::of_power(1.005).is_linear());
}

}  // namespace
}  // namespace firstlight::render
