#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::golden {

/// A picture as its file stores it: 8 bits a channel, red green blue, rows from the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  std::array<int, 3> at(int x, int y) const;
  bool operator==(const Picture&) const = default;
};

/// Nothing when the file cannot be read as a picture; `why` then says so.
std::optional<Picture> read_picture(const std::filesystem::path& file, std::string& why);
bool write_picture(const Picture& picture, const std::filesystem::path& file);

/// How far two pictures of one size are apart.
struct Comparison {
  double share = 0;                      ///< of the pixels that differ by at most `tolerance` in every channel, 0 to 1
  double psnr = 0;                       ///< dB over all channels; infinite when they are equal
  int worst = 0;                         ///< the largest difference of a channel, of 255
  int x = 0, y = 0;                      ///< where that is
  std::array<int, 3> first{}, second{};  ///< both colours there

  std::string summary() const;
};

/// A pixel agrees when no channel differs by more than 2 of 255.
inline constexpr int kTolerance = 2;

Comparison compare(const Picture& first, const Picture& second, int tolerance = kTolerance);

/// The difference of each channel, 16 times as strong, so that a single step can be seen.
Picture difference_picture(const Picture& first, const Picture& second);

}  // namespace firstlight::golden
