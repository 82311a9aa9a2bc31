#include "app/memory_size.h"

#include <gtest/gtest.h>

namespace firstlight::app {
namespace {

TEST(MemorySize, IsReadInItsUsualForms) {
  EXPECT_EQ(parse_memory_size("0"), 0u);
  EXPECT_EQ(parse_memory_size("1048576"), 1048576u);
  EXPECT_EQ(parse_memory_size("900B"), 900u);
  EXPECT_EQ(parse_memory_size("500k"), 512000u);
  for (const char* text : {"16M", "16m", "16MB", "16MiB", "16mib", "16384k"}) {
    EXPECT_EQ(parse_memory_size(text), 16u << 20) << text;
  }
  EXPECT_EQ(parse_memory_size("1.5G"), 3u << 29);
  EXPECT_EQ(parse_memory_size("2T"), std::size_t{2} << 40);
}

TEST(MemorySize, IsNothingElse) {
  for (const char* text : {"", "M", "-1", "-1M", "+1M", "16X", "16Mx", "16 M", "1e9", "0x10", "inf", "nan", ".5M",
                           "16iB", "16MBB", "99999999999T", "1e400", "99999999999999999999999999"}) {
    EXPECT_FALSE(parse_memory_size(text)) << text;
  }
}

TEST(MemorySize, HasAShortForm) {
  EXPECT_EQ(short_memory_size(900), "900 bytes");
  EXPECT_EQ(short_memory_size(16u << 20), "16 M");
  EXPECT_EQ(short_memory_size(3u << 29), "1.5 G");
  EXPECT_EQ(short_memory_size(64u << 10), "64 k");
}

TEST(MemorySize, ADefaultIsAShareOfTheMachine) { EXPECT_GT(default_queue_memory(), std::size_t{1} << 20); }

}  // namespace
}  // namespace firstlight::app
