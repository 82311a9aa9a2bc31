#include "render/math/zeroed_pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>

namespace firstlight::render {
namespace {

TEST(ZeroedPages, BeginAsZeros) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{5000}, std::size_t{3} << 20}) {
    ZeroedPages<std::uint32_t> pages(size);
    EXPECT_EQ(pages.size(), size);
    EXPECT_EQ(std::ranges::count(pages, 0u), static_cast<std::ptrdiff_t>(size));
    pages[size - 1] = 7;
    pages.touch(size);
    EXPECT_EQ(pages[size - 1], 7u);
  }
}

TEST(ZeroedPages, MoveWithWhatTheyHold) {
  ZeroedPages<std::uint32_t> first(1000);
  first[10] = 3;
  ZeroedPages<std::uint32_t> second(std::move(first));
  EXPECT_EQ(second[10], 3u);
  ZeroedPages<std::uint32_t> third;
  EXPECT_TRUE(third.empty());
  third = std::move(second);
  EXPECT_EQ(third[10], 3u);
  third = ZeroedPages<std::uint32_t>();
  EXPECT_TRUE(third.empty());
}

TEST(ZeroedPages, AreRefusedWhereThereIsNoRoom) {
  EXPECT_THROW(ZeroedPages<std::uint8_t>{std::numeric_limits<std::size_t>::max()}, std::bad_alloc);
  EXPECT_THROW(ZeroedPages<std::uint8_t>(std::size_t{1} << 60), std::bad_alloc);
  EXPECT_THROW(ZeroedPages<std::uint64_t>(std::size_t{1} << 62), std::bad_alloc);
}

}  // namespace
}  // namespace firstlight::render
