#include "priority/schemes.h"

#include "tests/priority/order_support.h"

#include <gtest/gtest.h>

#include <limits>

namespace firstlight::priority {
namespace {

using render::RayKind;
using render::RayTask;
using render::Rgb;

Key key_by(std::string_view scheme, const RayTask& of) { return key_of(*scheme_of(scheme), of); }

RayTask from_object(std::uint16_t object) {
  RayTask out = task(RayKind::reflection, 0.5f);
  out.object = object;
  return out;
}

RayTask feeler(std::uint32_t light, const Rgb& at_stake = Rgb(0.5f)) {
  RayTask out = task(RayKind::shadow, 0.5f);
  out.set_feeler(light, render::PackedRgb(at_stake));
  return out;
}

TEST(Schemes, AreFoundByTheirNames) {
  for (const SchemeRow& row : schemes()) EXPECT_EQ(find_scheme(row.name), &row);
  EXPECT_EQ(find_scheme("contributio"), nullptr);
  EXPECT_NE(find_scheme(kDefaultScheme), nullptr);
}

TEST(Schemes, GiveKeysBelowTheirCount) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const SchemeRow& row : schemes()) {
    if (row.make == nullptr || row.name == "expr") continue;
    const auto scheme = scheme_of(row.example);
    EXPECT_LE(scheme->key_count(), kBuckets);
    for (const float weight : {0.0f, -1.0f, 1e-45f, 1e38f, kInfinity, -kInfinity, kNan, -kNan}) {
      for (const RayKind kind : {RayKind::primary, RayKind::reflection, RayKind::transmission, RayKind::shadow}) {
        RayTask odd = task(kind, weight, 255);
        odd.sample = 0xffffffff;
        odd.origin = render::Vec3(weight);
        EXPECT_LT(key_of(*scheme, odd), scheme->key_count()) << row.name << ' ' << weight;
      }
    }
  }
}

TEST(Level, FewerLevelsLeaveFirst) {
  for (int level = 0; level < 6; ++level) {
    EXPECT_GT(key_by("level", task(RayKind::reflection, 0.1f, level)),
              key_by("level", task(RayKind::transmission, 0.9f, level + 1)));
  }
}

TEST(RayType, WithoutAListShadowsLeaveLast) {
  EXPECT_GT(key_by("ray-type", task(RayKind::primary, 0.1f)), key_by("ray-type", task(RayKind::reflection, 0.9f)));
  EXPECT_GT(key_by("ray-type", task(RayKind::reflection, 0.1f)), key_by("ray-type", task(RayKind::transmission, 0.9f)));
  EXPECT_GT(key_by("ray-type", task(RayKind::transmission, 0.1f)), key_by("ray-type", task(RayKind::shadow, 0.9f)));
}

TEST(RayType, FollowsTheUsersOrderAndKeepsPrimaryRaysInFront) {
  const auto scheme = scheme_of("ray-type(shadow, transmission)");
  EXPECT_GT(key_of(*scheme, task(RayKind::primary, 1)), key_of(*scheme, task(RayKind::shadow, 1)));
  EXPECT_GT(key_of(*scheme, task(RayKind::shadow, 1)), key_of(*scheme, task(RayKind::transmission, 1)));
  EXPECT_GT(key_of(*scheme, task(RayKind::transmission, 1)), key_of(*scheme, task(RayKind::reflection, 1)));
  const auto primary_last = scheme_of("ray-type(reflection transmission shadow primary)");
  EXPECT_LT(key_of(*primary_last, task(RayKind::primary, 1)), key_of(*primary_last, task(RayKind::shadow, 1)));
}

TEST(RayType, UnknownAndRepeatedKindsAreErrors) {
  EXPECT_EQ(error_of("ray-type(reflection glass)"),
            "column 21: expected a kind of ray, found 'glass'; there are primary, reflection, transmission, shadow\n"
            "  ray-type(reflection glass)\n                      ^~~~~");
  EXPECT_NE(error_of("ray-type(shadow shadow)").find("column 17: 'shadow' is named twice"), std::string::npos);
  EXPECT_NE(error_of("ray-type()").find("expected a kind of ray, found ')'"), std::string::npos);
}

TEST(ObjectOrder, NamedObjectsLeaveInTheirOrderAndOthersLast) {
  const auto scheme = scheme_of("object(Glass Chair)");
  EXPECT_GT(key_of(*scheme, from_object(4)), key_of(*scheme, from_object(1)));
  EXPECT_EQ(key_of(*scheme, from_object(1)), key_of(*scheme, from_object(2)));
  EXPECT_GT(key_of(*scheme, from_object(2)), key_of(*scheme, from_object(0)));
  EXPECT_EQ(key_of(*scheme, from_object(0)), key_of(*scheme, from_object(5)));
}

TEST(ObjectOrder, ANameMeansTheObjectWhereverItIsAndAWordAllOfThatShape) {
  const auto legs = scheme_of("object(Leg)");
  EXPECT_EQ(key_of(*legs, from_object(1)), 1u);
  EXPECT_EQ(key_of(*legs, from_object(3)), 1u);
  EXPECT_EQ(key_of(*legs, from_object(2)), 0u);
  const auto spheres = scheme_of("object(sphere)");
  EXPECT_EQ(key_of(*spheres, from_object(5)), 1u);
  EXPECT_EQ(key_of(*spheres, from_object(0)), 0u);
}

TEST(ObjectOrder, WithoutAListTheSceneDecides) {
  const auto scheme = scheme_of("object");
  for (std::uint16_t i = 0; i < 5; ++i) {
    EXPECT_GT(key_of(*scheme, from_object(i)), key_of(*scheme, from_object(i + 1)));
  }
}

TEST(ObjectOrder, UnknownNamesAreErrorsThatTellTheNearest) {
  EXPECT_EQ(error_of("object(Glass Chiar)"),
            "column 14: the scene has no object 'Chiar' (the nearest is 'Chair')\n  object(Glass Chiar)\n"
            "               ^~~~~");
}

TEST(RegionOrder, RectanglesLeaveInTheirOrderAndTheRestLast) {
  const auto scheme = scheme_of("region(10,10,19,19 20,10,29,19)");
  EXPECT_EQ(key_of(*scheme, task(RayKind::reflection, 1, 0, 10, 10)), 2u);
  EXPECT_EQ(key_of(*scheme, task(RayKind::reflection, 1, 0, 19, 19)), 2u);
  EXPECT_EQ(key_of(*scheme, task(RayKind::reflection, 1, 0, 20, 10)), 1u);
  EXPECT_EQ(key_of(*scheme, task(RayKind::reflection, 1, 0, 9, 10)), 0u);
  EXPECT_EQ(key_of(*scheme, task(RayKind::reflection, 1, 0, 15, 20)), 0u);
  EXPECT_EQ(key_by("region", task(RayKind::reflection, 1, 0, 50, 40)), 1u);
  EXPECT_EQ(key_by("region", task(RayKind::reflection, 1, 0, 0, 40)), 0u);
}

TEST(RegionOrder, OverlapAndEmptyRectanglesAreErrors) {
  EXPECT_EQ(error_of("region(0,0,9,9 5,5,20,20)"),
            "column 16: the rectangle 5,5,20,20 overlaps 0,0,9,9\n  region(0,0,9,9 5,5,20,20)\n                 ^");
  EXPECT_NE(error_of("region(5,0,4,9)").find("the rectangle 5,0,4,9 is empty"), std::string::npos);
  EXPECT_NE(error_of("region(5,0,4)").find("expected a pixel's coordinate, found ')'"), std::string::npos);
  EXPECT_NE(error_of("region(5,0,99999999999,3)").find("too large"), std::string::npos);
}

TEST(SurfaceOrder, ClearSurfacesAndMirrorsLeaveFirstUnlessTheUserSaysOtherwise) {
  const auto scheme = scheme_of("surface");
  EXPECT_GT(key_of(*scheme, from_object(4)), key_of(*scheme, from_object(0)));
  EXPECT_GT(key_of(*scheme, from_object(0)), key_of(*scheme, from_object(2)));
  EXPECT_GT(key_of(*scheme, from_object(2)), key_of(*scheme, from_object(1)));
  const auto plain_first = scheme_of("surface(plain)");
  EXPECT_GT(key_of(*plain_first, from_object(5)), key_of(*plain_first, from_object(4)));
}

TEST(ComplexityOrder, ObjectsOfFewerPartsLeaveFirst) {
  EXPECT_GT(key_by("complexity", from_object(1)), key_by("complexity", from_object(2)));
  EXPECT_GT(key_by("complexity", from_object(2)), key_by("complexity", from_object(3)));
}

TEST(ObjectSchemes, PrimaryRaysComeFirst) {
  RayTask primary = task(RayKind::primary, 1.0f);
  for (const char* text : {"object(Glass)", "object", "surface", "complexity"}) {
    const auto scheme = scheme_of(text);
    EXPECT_EQ(key_of(*scheme, primary), scheme->key_count() - 1) << text;
    EXPECT_FALSE(scheme->tells_pixels_apart());
  }
}

TEST(DistanceOrder, SurfacesNearTheEyeLeaveFirst) {
  RayTask near = task(RayKind::reflection, 0.5f);
  near.origin = render::Vec3(0.0, 3.0, 4.0);
  RayTask far = near;
  far.origin = render::Vec3(0.0, 6.0, 8.0);
  EXPECT_EQ(key_by("distance", near), key_by("distance", far) + 8);
}

TEST(LightOrder, BrightLightsLeaveFirstOrThoseThatAreNamed) {
  EXPECT_GT(key_by("light", feeler(2)), key_by("light", feeler(0)));
  EXPECT_GT(key_by("light", feeler(0)), key_by("light", feeler(1)));
  const auto scheme = scheme_of("light(1 Lamp)");
  EXPECT_GT(key_of(*scheme, feeler(1)), key_of(*scheme, feeler(0)));
  EXPECT_GT(key_of(*scheme, feeler(0)), key_of(*scheme, feeler(2)));
  EXPECT_GT(key_of(*scheme, task(RayKind::reflection, 0.1f)), key_of(*scheme, feeler(1)));
  EXPECT_EQ(key_by("light(Sun)", feeler(2)), 1u);
  EXPECT_NE(error_of("light(3)").find("column 7: there is no light '3'"), std::string::npos);
  EXPECT_NE(error_of("light(Lampe)").find("(the nearest is 'Lamp')"), std::string::npos);
}

TEST(LightOrder, ARecordLeavesWithTheBestOfItsFeelers) {
  RayTask record = feeler(0);
  ASSERT_TRUE(record.add_feeler(2, render::PackedRgb(Rgb(0.1f))));
  EXPECT_EQ(key_by("light", record), key_by("light", feeler(2)));
}

TEST(LightDistanceOrder, NearLightsLeaveFirst) {
  EXPECT_GT(key_by("light-distance", feeler(1)), key_by("light-distance", feeler(0)));
  EXPECT_GT(key_by("light-distance", feeler(0)), key_by("light-distance", feeler(2)));
}

TEST(LightColourOrder, GoesByTheChannelThatStandsOut) {
  const RayTask white = feeler(0, Rgb(0.9f, 1.0f, 0.9f));
  const RayTask red = feeler(0, Rgb(1.0f, 0.5f, 0.2f));
  const RayTask blue = feeler(0, Rgb(0.1f, 0.1f, 0.2f));
  EXPECT_GT(key_by("light-colour", white), key_by("light-colour", red));
  EXPECT_GT(key_by("light-colour", red), key_by("light-colour", blue));
  EXPECT_GT(key_by("light-colour(blue)", blue), key_by("light-colour(blue)", white));
}

TEST(SampleOrder, FirstSamplesOfPixelsLeaveBeforeFurtherOnes) {
  RayTask further = task(RayKind::reflection, 1.0f);
  further.sample = kPictureWidth * kPictureHeight;
  EXPECT_GT(key_by("sample", task(RayKind::shadow, 0.1f, 5, 99, 79)), key_by("sample", further));
}

}  // namespace
}  // namespace firstlight::priority
