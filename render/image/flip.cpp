#include "render/image/flip.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace firstlight::render {
namespace {

constexpr double kPi = std::numbers::pi;

// The paper's constants: exponents of the colour and the feature difference, and where the curve of the colour
// difference bends.
constexpr float kColorExponent = 0.7f;
constexpr float kFeatureExponent = 0.5f;
constexpr float kBendAt = 0.4f;
constexpr float kBendTo = 0.95f;
// Width of the features that are looked for, in degrees.
constexpr double kFeatureWidth = 0.082;

struct Triple {
  float x, y, z;
};

// Linear sRGB (IEC 61966-2-1, white point D65) to XYZ relative to that white, row by row; and back.
constexpr std::array<Triple, 3> kToXyz{{{0.4124564f / 0.9504700f, 0.3575761f / 0.9504700f, 0.1804375f / 0.9504700f},
                                        {0.2126729f, 0.7151522f, 0.0721750f},
                                        {0.0193339f / 1.0888300f, 0.1191920f / 1.0888300f, 0.9503041f / 1.0888300f}}};

float dot(const Triple& row, const Triple& v) { return row.x * v.x + row.y * v.y + row.z * v.z; }

Triple to_xyz(const Triple& rgb) { return {dot(kToXyz[0], rgb), dot(kToXyz[1], rgb), dot(kToXyz[2], rgb)}; }

std::array<Triple, 3> inverse(const std::array<Triple, 3>& m) {
  const auto cross = [](const Triple& a, const Triple& b) {
    return Triple{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Triple c0 = cross(m[1], m[2]);
  const Triple c1 = cross(m[2], m[0]);
  const Triple c2 = cross(m[0], m[1]);
  const float d = 1.0f / dot(m[0], c0);
  return {{{c0.x * d, c1.x * d, c2.x * d}, {c0.y * d, c1.y * d, c2.y * d}, {c0.z * d, c1.z * d, c2.z * d}}};
}

/// L*a*b*, with a* and b* shrunk where it is dark: colours look paler there (Hunt).
Triple to_hunt_lab(const Triple& rgb) {
  const Triple xyz = to_xyz(rgb);
  const auto f = [](float t) {
    constexpr float kDelta = 6.0f / 29.0f;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
  };
  const float fy = f(xyz.y);
  const float lightness = 116.0f * fy - 16.0f;
  const float hunt = 0.01f * lightness;
  return {lightness, hunt * 500.0f * (f(xyz.x) - fy), hunt * 200.0f * (fy - f(xyz.z))};
}

/// Distance for large colour differences: city block in lightness, Euclid in colour.
float hyab(const Triple& a, const Triple& b) {
  const float da = a.y - b.y;
  const float db = a.z - b.z;
  return std::abs(a.x - b.x) + std::sqrt(da * da + db * db);
}

/// The largest difference that is reckoned with: that of the green and the blue primary.
float most_color_difference() {
  return std::pow(hyab(to_hunt_lab({0.0f, 1.0f, 0.0f}), to_hunt_lab({0.0f, 0.0f, 1.0f})), kColorExponent);
}

/// Compresses large differences: [0, kBendAt most] takes [0, kBendTo], what is above the rest.
float bend(float difference, float most) {
  const float at = kBendAt * most;
  if (difference < at) return kBendTo / at * difference;
  return kBendTo + (difference - at) / (most - at) * (1.0f - kBendTo);
}

float shown(float channel) { return channel > 0.0f ? std::min(channel, 1.0f) : 0.0f; }

/// Calls body(y) for all rows.
template <class Body>
void each_row(int height, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) body(y);
  });
}

/// exp(-k d^2) at d = -radius .. radius.
std::vector<double> gaussian(double k, int radius) {
  std::vector<double> taps;
  for (int d = -radius; d <= radius; ++d) taps.push_back(std::exp(-k * d * d));
  return taps;
}

double sum(const std::vector<double>& taps) {
  double total = 0.0;
  for (const double tap : taps) total += tap;
  return total;
}

std::vector<float> scaled(const std::vector<double>& taps, double factor) {
  std::vector<float> result;
  for (const double tap : taps) result.push_back(static_cast<float>(tap * factor));
  return result;
}

/// Positive taps sum up to 1 and negative ones to -1.
std::vector<float> balanced(const std::vector<double>& taps) {
  double positive = 0.0;
  double negative = 0.0;
  for (const double tap : taps) (tap > 0.0 ? positive : negative) += tap;
  std::vector<float> result;
  for (const double tap : taps) result.push_back(static_cast<float>(tap > 0.0 ? tap / positive : -tap / negative));
  return result;
}

}  // namespace

Flip::Flip(std::span<const Rgb> reference, int width, int height, double pixels_per_degree)
    : width_(width), height_(height), filters_(make_filters(pixels_per_degree)), reference_(see(reference)) {}

Flip::Filters Flip::make_filters(double pixels_per_degree) {
  // Contrast sensitivity of the eye to a pattern of so many cycles a degree, as Gaussians in space:
  // a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees. Table 1 of the paper.
  struct Sensitivity {
    double a, b;
  };
  constexpr Sensitivity kAchromatic{1.0, 0.0047};
  constexpr Sensitivity kRedGreen{1.0, 0.0053};
  constexpr Sensitivity kBlueYellow1{34.1, 0.04};
  constexpr Sensitivity kBlueYellow2{13.5, 0.025};
  // Three standard deviations of the widest.
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(kBlueYellow1.b / (2.0 * kPi * kPi)) * pixels_per_degree));
  const auto taps_of = [&](const Sensitivity& s) {
    return gaussian(kPi * kPi / (s.b * pixels_per_degree * pixels_per_degree), radius);
  };
  Filters filters;
  for (const auto& [sensitivity, taps] :
       {std::pair(kAchromatic, &filters.achromatic), std::pair(kRedGreen, &filters.red_green)}) {
    const std::vector<double> g = taps_of(sensitivity);
    *taps = scaled(g, 1.0 / sum(g));
  }
  // A sum of two Gaussians, whose weights in the plane add up to 1.
  const std::vector<double> wide = taps_of(kBlueYellow1);
  const std::vector<double> narrow = taps_of(kBlueYellow2);
  const double wide_height = kBlueYellow1.a * std::sqrt(kPi / kBlueYellow1.b);
  const double narrow_height = kBlueYellow2.a * std::sqrt(kPi / kBlueYellow2.b);
  const double whole = wide_height * sum(wide) * sum(wide) + narrow_height * sum(narrow) * sum(narrow);
  filters.blue_yellow_1 = scaled(wide, std::sqrt(wide_height / whole));
  filters.blue_yellow_2 = scaled(narrow, std::sqrt(narrow_height / whole));

  const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
  const int feature_radius = static_cast<int>(std::ceil(3.0 * deviation));
  const std::vector<double> g = gaussian(0.5 / (deviation * deviation), feature_radius);
  std::vector<double> first = g;
  std::vector<double> second = g;
  for (int d = -feature_radius; d <= feature_radius; ++d) {
    const auto i = static_cast<std::size_t>(d + feature_radius);
    first[i] *= -d;
    second[i] *= d * d / (deviation * deviation) - 1.0;
  }
  filters.smooth = scaled(g, 1.0 / sum(g));
  filters.edge = balanced(first);
  filters.point = balanced(second);
  return filters;
}

/// Beyond the border the plane goes on as at the border.
Flip::Plane Flip::filter(const Plane& plane, const Taps& along_x, const Taps& along_y) const {
  const auto width = static_cast<std::size_t>(width_);
  const auto row_of = [&](int y) { return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * width; };
  Plane between(plane.size());
  each_row(height_, [&](int y) {
    const std::size_t radius = along_x.size() / 2;
    const float* const row = plane.data() + row_of(y);
    std::vector<float> padded(width + 2 * radius);
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width - 1]);
    float* const out = between.data() + row_of(y);
    for (std::size_t tap = 0; tap < along_x.size(); ++tap) {
      const float* const in = padded.data() + tap;
      for (std::size_t x = 0; x < width; ++x) out[x] += along_x[tap] * in[x];
    }
  });
  Plane result(plane.size());
  each_row(height_, [&](int y) {
    const int radius = static_cast<int>(along_y.size() / 2);
    float* const out = result.data() + row_of(y);
    for (std::size_t tap = 0; tap < along_y.size(); ++tap) {
      const float* const in = between.data() + row_of(y + static_cast<int>(tap) - radius);
      for (std::size_t x = 0; x < width; ++x) out[x] += along_y[tap] * in[x];
    }
  });
  return result;
}

Flip::Seen Flip::see(std::span<const Rgb> picture) const {
  // Opponent colours YCxCz: a linear relative of L*a*b*, in which the eye's sensitivities are known.
  const std::size_t size = picture.size();
  Plane luminance(size);  // in [0, 1]; Y of the opponent space is 116 times this, less 16
  Plane red_green(size);
  Plane blue_yellow(size);
  const auto width = static_cast<std::size_t>(width_);
  each_row(height_, [&](int y) {
    for (std::size_t i = static_cast<std::size_t>(y) * width; i < (static_cast<std::size_t>(y) + 1) * width; ++i) {
      const Triple xyz = to_xyz({shown(picture[i].x), shown(picture[i].y), shown(picture[i].z)});
      luminance[i] = xyz.y;
      red_green[i] = 500.0f * (xyz.x - xyz.y);
      blue_yellow[i] = 200.0f * (xyz.y - xyz.z);
    }
  });

  const Plane edge_x = filter(luminance, filters_.edge, filters_.smooth);
  const Plane edge_y = filter(luminance, filters_.smooth, filters_.edge);
  const Plane point_x = filter(luminance, filters_.point, filters_.smooth);
  const Plane point_y = filter(luminance, filters_.smooth, filters_.point);
  // The filters are linear and of sum 1, so they may be applied before the scaling and the shift of Y.
  luminance = filter(luminance, filters_.achromatic, filters_.achromatic);
  red_green = filter(red_green, filters_.red_green, filters_.red_green);
  const Plane wide = filter(blue_yellow, filters_.blue_yellow_1, filters_.blue_yellow_1);
  const Plane narrow = filter(blue_yellow, filters_.blue_yellow_2, filters_.blue_yellow_2);

  const std::array<Triple, 3> to_rgb = inverse(kToXyz);
  Seen seen{Plane(size), Plane(size), Plane(size), Plane(size), Plane(size)};
  each_row(height_, [&](int y) {
    for (std::size_t i = static_cast<std::size_t>(y) * width; i < (static_cast<std::size_t>(y) + 1) * width; ++i) {
      const Triple xyz{luminance[i] + red_green[i] / 500.0f, luminance[i],
                       luminance[i] - (wide[i] + narrow[i]) / 200.0f};
      const Triple lab =
          to_hunt_lab({shown(dot(to_rgb[0], xyz)), shown(dot(to_rgb[1], xyz)), shown(dot(to_rgb[2], xyz))});
      seen.lightness[i] = lab.x;
      seen.a[i] = lab.y;
      seen.b[i] = lab.z;
      seen.edges[i] = std::sqrt(edge_x[i] * edge_x[i] + edge_y[i] * edge_y[i]);
      seen.points[i] = std::sqrt(point_x[i] * point_x[i] + point_y[i] * point_y[i]);
    }
  });
  return seen;
}

std::vector<float> Flip::map(std::span<const Rgb> test) const {
  const Seen seen = see(test);
  const float most = most_color_difference();
  std::vector<float> errors(test.size());
  const auto width = static_cast<std::size_t>(width_);
  each_row(height_, [&](int y) {
    for (std::size_t i = static_cast<std::size_t>(y) * width; i < (static_cast<std::size_t>(y) + 1) * width; ++i) {
      const float apart =
          hyab({reference_.lightness[i], reference_.a[i], reference_.b[i]}, {seen.lightness[i], seen.a[i], seen.b[i]});
      const float color = bend(std::pow(apart, kColorExponent), most);
      const float feature =
          std::max(std::abs(reference_.edges[i] - seen.edges[i]), std::abs(reference_.points[i] - seen.points[i])) /
          std::numbers::sqrt2_v<float>;
      errors[i] = std::pow(color, 1.0f - std::pow(feature, kFeatureExponent));
    }
  });
  return errors;
}

double Flip::mean(std::span<const Rgb> test) const {
  double total = 0.0;
  for (const float error : map(test)) total += error;
  return test.empty() ? 0.0 : total / static_cast<double>(test.size());
}

}  // namespace firstlight::render
