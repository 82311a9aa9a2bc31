#include "render/texture/density_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <system_error>

namespace firstlight::render {
namespace {

/// A cubic through fb and fc, level with their neighbours. In single precision, as in POV-Ray.
float cubic(float t, float fa, float fb, float fc, float fd) {
  const auto single = [](double value) { return static_cast<float>(value); };
  const float b = single((fc - fa) * 0.5);
  const float d = single((fd - fb) * 0.5);
  const float e = single(2.0 * static_cast<double>(fb - fc) + static_cast<double>(b) + static_cast<double>(d));
  const float f = single(-3.0 * static_cast<double>(fb - fc) - 2.0 * static_cast<double>(b) - static_cast<double>(d));
  return ((e * t + f) * t + b) * t + fb;
}

/// Beyond the end the grid begins again. What lies before the start is where POV-Ray finds it, whose numbers have no sign.
std::size_t around(std::uint64_t index, std::size_t size) { return static_cast<std::size_t>(index % size); }

}  // namespace

std::shared_ptr<const DensityGrid> DensityGrid::read(const std::string& path, std::string& error) {
  const auto fail = [&](const char* why) {
    error = "cannot read '" + path + "': " + why;
    return nullptr;
  };
  std::error_code failed;
  const std::uintmax_t length = std::filesystem::file_size(path, failed);
  constexpr std::size_t kHeader = 6;
  if (failed) return fail("there is no such file");
  if (length < kHeader) return fail("the file ends too early");
  if (length > kMostBytes) return fail("it is too large");
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(length));
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) return fail("it cannot be opened");
  const bool whole = std::fread(bytes.data(), 1, bytes.size(), file) == bytes.size();
  std::fclose(file);
  if (!whole) return fail("the file ends too early");
  const std::shared_ptr<DensityGrid> grid(new DensityGrid());
  for (std::size_t i = 0; i < 3; ++i) grid->size_[i] = static_cast<std::size_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
  const std::uint64_t count = std::uint64_t{grid->size_[0]} * grid->size_[1] * grid->size_[2];
  const std::uint64_t rest = length - kHeader;
  if (count == 0 || (rest != count && rest != 2 * count && rest != 4 * count)) {
    return fail("its size is not that of its densities");
  }
  grid->bytes_ = static_cast<std::size_t>(rest / count);
  bytes.erase(bytes.begin(), bytes.begin() + kHeader);
  grid->densities_ = std::move(bytes);
  return grid;
}

double DensityGrid::at(std::size_t x, std::size_t y, std::size_t z) const {
  const std::uint8_t* const first = densities_.data() + ((z * size_[1] + y) * size_[0] + x) * bytes_;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < bytes_; ++i) number = number << 8 | first[i];
  return number / (bytes_ == 4 ? 4294967295.0 : bytes_ == 2 ? 65535.0 : 255.0);
}

double DensityGrid::value(const Vec3& point, int interpolation) const {
  const auto within = [](double c) { return c >= 0.0 && c < 1.0; };
  if (!within(point.x) || !within(point.y) || !within(point.z)) return 0.0;
  const Vec3 place(point.x * static_cast<double>(size_[0]), point.y * static_cast<double>(size_[1]),
                   point.z * static_cast<double>(size_[2]));
  const int kind = interpolation % 10;
  if (kind == 1) return std::max(trilinear(place), 0.0);
  if (kind != 0) return std::max(tricubic(place), 0.0);
  const auto x = static_cast<std::size_t>(place.x), y = static_cast<std::size_t>(place.y),
             z = static_cast<std::size_t>(place.z);
  return x < size_[0] && y < size_[1] && z < size_[2] ? at(x, y, z) : 0.0;
}

double DensityGrid::trilinear(const Vec3& place) const {
  const auto cell = [](double c, std::size_t size) { return std::min(static_cast<std::size_t>(c), size - 1); };
  const Cell low = {cell(place.x, size_[0]), cell(place.y, size_[1]), cell(place.z, size_[2])};
  const Cell high = {around(low[0] + 1, size_[0]), around(low[1] + 1, size_[1]), around(low[2] + 1, size_[2])};
  const double x = place.x - std::floor(place.x), y = place.y - std::floor(place.y), z = place.z - std::floor(place.z);
  const auto plane = [&](std::size_t at_z) {
    return (at(low[0], low[1], at_z) * (1.0 - x) + at(high[0], low[1], at_z) * x) * (1.0 - y) +
           (at(low[0], high[1], at_z) * (1.0 - x) + at(high[0], high[1], at_z) * x) * y;
  };
  return plane(low[2]) * (1.0 - z) + plane(high[2]) * z;
}

double DensityGrid::tricubic(const Vec3& place) const {
  const auto x = static_cast<std::uint64_t>(place.x), y = static_cast<std::uint64_t>(place.y),
             z = static_cast<std::uint64_t>(place.z);
  const auto rest = [](double c) { return static_cast<float>(c - std::floor(c)); };
  float rows[4];
  for (std::uint64_t i = 0; i < 4; ++i) {
    const std::size_t at_x = around(i + x - 1, size_[0]);
    float columns[4];
    for (std::uint64_t j = 0; j < 4; ++j) {
      const std::size_t at_y = around(j + y - 1, size_[1]);
      const auto density = [&](std::uint64_t k) {
        return static_cast<float>(at(at_x, at_y, around(k + z - 1, size_[2])));
      };
      columns[j] = cubic(rest(place.z), density(0), density(1), density(2), density(3));
    }
    rows[i] = cubic(rest(place.y), columns[0], columns[1], columns[2], columns[3]);
  }
  return static_cast<double>(cubic(rest(place.x), rows[0], rows[1], rows[2], rows[3]));
}

}  // namespace firstlight::render
