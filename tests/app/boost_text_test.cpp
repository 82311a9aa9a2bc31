#include "app/boost_text.h"

#include <gtest/gtest.h>

namespace firstlight::app {
namespace {

using priority::Boost;

Boost good(std::string_view text, std::span<const Boost> present = {}) {
  std::string error;
  const auto boost = parse_boost(text, present, error);
  EXPECT_TRUE(boost) << text << ": " << error;
  return boost.value_or(Boost{});
}

std::string complaint(std::string_view text) {
  std::string error;
  EXPECT_FALSE(parse_boost(text, {}, error)) << text;
  EXPECT_NE(error, "") << text;
  return error;
}

TEST(BoostText, NamesARegionAnObjectOrALight) {
  const Boost region = good("region 10 20 30 40 by -2 as face");
  EXPECT_EQ(region.kind, Boost::Kind::region);
  EXPECT_EQ(region.region.left, 10);
  EXPECT_EQ(region.region.top, 20);
  EXPECT_EQ(region.region.right, 30);
  EXPECT_EQ(region.region.bottom, 40);
  EXPECT_EQ(region.by, -2);
  EXPECT_EQ(region.name, "face");
  const Boost object = good(" object\tFlake ");
  EXPECT_EQ(object.kind, Boost::Kind::object);
  EXPECT_EQ(object.object, "Flake");
  EXPECT_EQ(object.by, 1);
  EXPECT_EQ(object.name, "Flake");
  const Boost light = good("light 1 as lamp by 3");
  EXPECT_EQ(light.kind, Boost::Kind::light);
  EXPECT_EQ(light.light, 1);
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(light.by, 3);
}

TEST(BoostText, GivesANameThatIsFree) {
  const std::vector<Boost> present{good("region 0 0 1 1"), good("region 0 0 1 1 as region-2")};
  EXPECT_EQ(good("region 5 5 6 6", present).name, "region-3");
  EXPECT_EQ(good("region 5 5 6 6 as region", present).name, "region");
}

TEST(BoostText, IsWrittenAsItIsRead) {
  for (const char* text : {"region 1 2 3 4", "object Flake", "light 0"}) {
    const Boost boost = good(std::string(text) + " by 7 as a");
    EXPECT_EQ(boost_text(boost), std::string("a: ") + text + " by 7");
  }
}

TEST(BoostText, SaysWhatItExpected) {
  EXPECT_EQ(complaint(""), "expected region, object or light, found the end");
  EXPECT_EQ(complaint("place 1"), "expected region, object or light, found 'place'");
  EXPECT_NE(complaint("region 1 2 3").find("lower edge"), std::string::npos);
  EXPECT_NE(complaint("region 1 2.5 3 4").find("'2.5'"), std::string::npos);
  EXPECT_NE(complaint("region 1 99999999999 3 4").find("'99999999999'"), std::string::npos);
  EXPECT_NE(complaint("light").find("number of a light"), std::string::npos);
  EXPECT_NE(complaint("object").find("identifier"), std::string::npos);
  EXPECT_NE(complaint("light 1 by").find("after 'by'"), std::string::npos);
  EXPECT_NE(complaint("light 1 by 5000").find("1000 at most"), std::string::npos);
  EXPECT_NE(complaint("light 1 as all").find("'all'"), std::string::npos);
  EXPECT_NE(complaint("light 1 as a/b").find("'a/b'"), std::string::npos);
  EXPECT_NE(complaint("light 1 now").find("'now'"), std::string::npos);
}

}  // namespace
}  // namespace firstlight::app
