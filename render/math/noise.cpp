#include "render/math/noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace firstlight::render {
namespace {

// As POV-Ray's processors cut numbers: what does not fit becomes the lowest integer.
int cut(double value) { return value > -2147483649.0 && value < 2147483648.0 ? static_cast<int>(value) : INT_MIN; }

// a^2 (3 - 2a): from 0 to 1, level at both ends.
double s_curve(double a) { return a * a * (3.0 - 2.0 * a); }

/// The random numbers that POV-Ray makes its tables of: 15 bits of each state.
class TableRandom {
 public:
  explicit TableRandom(std::uint32_t seed) : state_(seed) {}
  unsigned next() {
    state_ = state_ * 1812433253u + 12345u;
    return (state_ >> 16) & 0x7fff;
  }

 private:
  std::uint32_t state_;
};

/// Two numbers that are worked on at once.
using Pair = double __attribute__((vector_size(16)));

/// Tables of the original noise: a permutation of the lattice's points, and the coefficients of the linear functions
/// that are blended between them.
class LatticeTables {
 public:
  /// The coefficients at a point of a field of vectors: of x and y side by side, and of z. The first of four is halved.
  struct Gradient {
    Pair xy[4];
    double z[4];
  };
  static constexpr unsigned kPoints = 4096;
  static const LatticeTables& get() {
    static const LatticeTables tables;
    return tables;
  }

  unsigned column(unsigned x, unsigned y) const { return permutation_[permutation_[x] ^ y]; }
  unsigned hash(unsigned x, unsigned y, unsigned z) const {
    constexpr unsigned kWithin = kPoints - 1;
    return permutation_[permutation_[permutation_[x & kWithin] ^ (y & kWithin)] ^ (z & kWithin)];
  }
  /// The first of the coefficients at a point, given its column().
  const double* coefficients(unsigned column, unsigned z) const { return &values_[entry(column, z)]; }
  const Gradient& gradient(unsigned column, unsigned z) const { return gradients_[entry(column, z)]; }

 private:
  unsigned entry(unsigned column, unsigned z) const { return permutation_[column ^ z] & 0xff; }
  LatticeTables() {
    for (unsigned i = 0; i < kPoints; ++i) permutation_[i] = static_cast<std::uint16_t>(i);
    TableRandom random(0);
    for (unsigned i = kPoints; i-- > 0;) std::swap(permutation_[i], permutation_[random.next() % kPoints]);
    std::copy_n(permutation_.begin(), kPoints, permutation_.begin() + kPoints);
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = value(static_cast<double>(i));
    for (std::size_t i = 0; i < gradients_.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double factor = k == 0 ? 0.5 : 1.0;
        gradients_[i].xy[k] = Pair{values_[i + k] * factor, values_[i + 4 + k] * factor};
        gradients_[i].z[k] = values_[i + 8 + k] * factor;
      }
    }
  }

  /// The checksum (CRC-16, polynomial 0x8005) over three doubles of 0.12345 * i, highest byte first, brought to -1 to 1
  /// and written with six digits. [R. Skinner's noise in the MTV ray tracer, whose table POV-Ray keeps]
  static double value(double i) {
    const auto bits = std::bit_cast<std::uint64_t>(i * 0.12345);
    unsigned sum = 0;
    for (unsigned byte = 0; byte < 24; ++byte) {
      sum ^= static_cast<unsigned>(bits >> (56 - 8 * (byte % 8))) & 0xff;
      for (int bit = 0; bit < 8; ++bit) sum = (sum & 1) != 0 ? (sum >> 1) ^ 0xa001 : sum >> 1;
    }
    std::array<char, 32> text{};
    const double exact = sum * 2.0 / 65535.0 - 1.0;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), exact, std::chars_format::general, 6).ptr;
    double rounded = 0.0;
    std::from_chars(text.data(), end, rounded);
    return rounded;
  }

  std::array<std::uint16_t, 2 * kPoints> permutation_{};
  std::array<double, 267> values_{};
  std::array<Gradient, 256> gradients_{};
};

/// A place in the lattice along one axis: the number of the point below, and the way from it.
struct Step {
  unsigned point;
  double from;  ///< 0 to 1
  explicit Step(double x) {
    constexpr int kOrigin = -10000;
    constexpr double kAlmostOne = 1.0 - 1e-10;
    const int whole = x >= 0.0 ? cut(x) : cut(x - kAlmostOne);
    point = (static_cast<unsigned>(whole) - static_cast<unsigned>(kOrigin)) & (LatticeTables::kPoints - 1);
    from = x - whole;
  }
};

/// The corners of one cell of the lattice about a point: calls visit(column, z, weight, way from the corner), written
/// out for each of them.
template <std::array<std::uint8_t, 8> kOrder, class Visit>
inline void visit_corners(const Vec3& p, const Visit& visit) {
  const LatticeTables& tables = LatticeTables::get();
  const Step x(p.x), y(p.y), z(p.z);
  const double to_x = s_curve(x.from), to_y = s_curve(y.from), to_z = s_curve(z.from);
  const std::array<double, 4> weight_xy = {(1.0 - to_x) * (1.0 - to_y), to_x * (1.0 - to_y), (1.0 - to_x) * to_y,
                                           to_x * to_y};
  const std::array<double, 2> weight_z = {1.0 - to_z, to_z};
  const std::array<double, 2> way_x = {x.from, x.from - 1.0}, way_y = {y.from, y.from - 1.0},
                              way_z = {z.from, z.from - 1.0};
  std::array<unsigned, 4> column{};
  for (unsigned i = 0; i < 4; ++i) column[i] = tables.column(x.point + (i & 1), y.point + (i >> 1));
  const auto visit_corner = [&]<unsigned corner>(std::integral_constant<unsigned, corner>) {
    constexpr unsigned i = corner & 3, up = corner >> 2;
    visit(tables, column[i], z.point + up, weight_xy[i] * weight_z[up], Vec3(way_x[i & 1], way_y[i >> 1], way_z[up]));
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (visit_corner(std::integral_constant<unsigned, kOrder[k]>()), ...);
  }
  (std::make_index_sequence<8>());
}

// Sums depend on their order in the last digit, and POV-Ray goes about the corners in two ways.
constexpr std::array<std::uint8_t, 8> kByRows = {0, 1, 2, 3, 4, 5, 6, 7};
constexpr std::array<std::uint8_t, 8> kRound = {0, 1, 3, 2, 6, 7, 5, 4};

double linear(const double* c, double weight, const Vec3& way) {
  return weight * (c[0] * 0.5 + c[1] * way.x + c[2] * way.y + c[3] * way.z);
}

double lattice_noise(const Vec3& point) {
  double sum = 0.0;
  visit_corners<kByRows>(point, [&](const LatticeTables& tables, unsigned column, unsigned z, double weight,
                                    const Vec3& way) { sum += linear(tables.coefficients(column, z), weight, way); });
  return sum;
}

/// Gradients on the unit sphere for the noise of generator 3. [K. Perlin's noise]
class GradientTables {
 public:
  static constexpr unsigned kSize = 2048;
  static const GradientTables& get() {
    static const GradientTables tables;
    return tables;
  }
  std::array<unsigned, 2 * (kSize + 1)> permutation{};
  std::array<Vec3, 2 * (kSize + 1)> gradients{};

 private:
  GradientTables() {
    TableRandom random(1);
    for (unsigned i = 0; i < kSize; ++i) gradients[i] = direction(random);
    for (unsigned i = 0; i < kSize; ++i) permutation[i] = i;
    // Every second entry is exchanged, beginning with the one behind the last, which is 0.
    for (unsigned i = kSize; i > 0; i -= 2) std::swap(permutation[i], permutation[random.next() % kSize]);
    for (unsigned i = 0; i < kSize + 2; ++i) {
      permutation[kSize + i] = permutation[i];
      gradients[kSize + i] = gradients[i];
    }
  }

  static Vec3 direction(TableRandom& random) {
    for (;;) {
      Vec3 v;
      for (int axis = 0; axis < 3; ++axis) {
        v[axis] = (static_cast<int>(random.next() % (2 * kSize)) - static_cast<int>(kSize)) / double{kSize};
      }
      const double square = v.x * v.x + v.y * v.y + v.z * v.z;
      if (square <= 1.0 && square >= 1e-5) return v * (1.0 / std::sqrt(square));
    }
  }
};

/// A place between two entries of the gradients along one axis.
struct Span {
  unsigned low, high;
  double from_low, from_high;
  explicit Span(double x) {
    constexpr double kFarFromZero = 10000000.023157213;  // keeps scenes away from the table's symmetry about 0
    const double shifted = x + kFarFromZero;
    const int whole = cut(std::floor(shifted));
    low = static_cast<unsigned>(whole) & (GradientTables::kSize - 1);
    high = (low + 1) & (GradientTables::kSize - 1);
    from_low = shifted - whole;
    from_high = from_low - 1.0;
  }
};

double blend(double t, double a, double b) { return a + t * (b - a); }

double gradient_noise(const Vec3& point) {
  const GradientTables& tables = GradientTables::get();
  const Span x(point.x), y(point.y), z(point.z);
  const unsigned left = tables.permutation[x.low], right = tables.permutation[x.high];
  const double to_x = s_curve(x.from_low), to_y = s_curve(y.from_low), to_z = s_curve(z.from_low);
  const auto along_x = [&](unsigned row, double from_y, unsigned layer, double from_z) {
    const Vec3& a = tables.gradients[tables.permutation[left + row] + layer];
    const Vec3& b = tables.gradients[tables.permutation[right + row] + layer];
    return blend(to_x, x.from_low * a.x + from_y * a.y + from_z * a.z, x.from_high * b.x + from_y * b.y + from_z * b.z);
  };
  const auto along_y = [&](unsigned layer, double from_z) {
    return blend(to_y, along_x(y.low, y.from_low, layer, from_z), along_x(y.high, y.from_high, layer, from_z));
  };
  return blend(to_z, along_y(z.low, z.from_low), along_y(z.high, z.from_high));
}

}  // namespace

unsigned lattice_hash(double x, double y, double z) {
  const auto whole = [](double c) { return static_cast<unsigned>(cut(c)); };
  return LatticeTables::get().hash(whole(x), whole(y), whole(z));
}

double noise(const Vec3& point, int generator) {
  double value = 0.0;
  if (generator == 3) {
    value = 0.5 * (1.59 * gradient_noise(point) + 0.985);
  } else if (generator == 2) {
    // The sum lies between -1.05242 and 0.988997. [POV-Ray 3.7]
    value = (lattice_noise(point) + 1.05242) * 0.48985582;
  } else {
    value = lattice_noise(point) + 0.5;
  }
  return value < 0.0 ? 0.0 : value > 1.0 ? 1.0 : value;
}

Vec3 dnoise(const Vec3& point) {
  Pair xy{0.0, 0.0};
  double z = 0.0;
  visit_corners<kRound>(
      point, [&](const LatticeTables& tables, unsigned column, unsigned layer, double weight, const Vec3& way) {
        const LatticeTables::Gradient& g = tables.gradient(column, layer);
        xy += weight * (g.xy[0] + g.xy[1] * way.x + g.xy[2] * way.y + g.xy[3] * way.z);
        z += weight * (g.z[0] + g.z[1] * way.x + g.z[2] * way.y + g.z[3] * way.z);
      });
  return {xy[0], xy[1], z};
}

double turbulence(const Vec3& point, const Octaves& octaves, int generator) {
  // The newer generators are spread to the range of the original.
  const auto spread = [&](const Vec3& p) {
    const double value = noise(p, generator);
    return generator > 1 ? 2.0 * value - 0.5 : value;
  };
  double sum = std::clamp(spread(point), 0.0, 1.0);
  double size = octaves.lambda, strength = octaves.omega;
  for (int octave = 2; octave <= octaves.count; ++octave) {
    sum += strength * spread(point * size);
    size *= octaves.lambda;
    strength *= octaves.omega;
  }
  return sum;
}

Vec3 dturbulence(const Vec3& point, const Octaves& octaves) {
  Vec3 sum = dnoise(point);
  double size = octaves.lambda, strength = octaves.omega;
  for (int octave = 2; octave <= octaves.count; ++octave) {
    sum += strength * dnoise(point * size);
    size *= octaves.lambda;
    strength *= octaves.omega;
  }
  return sum;
}

}  // namespace firstlight::render
