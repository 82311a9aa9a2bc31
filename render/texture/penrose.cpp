#include "render/texture/penrose.h"

#include "render/lanes/math.h"
#include "render/math/vec.h"

#include <algorithm>
#include <cmath>

namespace firstlight::render {
namespace {

constexpr double kPhi = 1.61803398874989484820;
constexpr double kPhi2 = kPhi * kPhi;
constexpr double kInside = 1e-6;  // between the values of two kinds

double radians(double degrees) { return degrees * 0.017453292519943295769; }
double sine(double degrees) { return steady::sine(radians(degrees)); }
double cosine(double degrees) { return steady::cosine(radians(degrees)); }

const double kSin18 = sine(18), kCos18 = cosine(18);
const double kSin36 = sine(36), kCos36 = cosine(36), kTan36 = kSin36 / kCos36;
const double kSin72 = sine(72), kCos72 = cosine(72), kTan72 = kSin72 / kCos72;
const double kTan54 = 1.0 / kTan36, kTan18 = 1.0 / kTan72;
/// Half the diagonal of a pentagon of side 1 seen from its middle: its outer radius.
const double kRadius = 0.5 / kSin36;
/// Its inner radius.
const double kInnerRadius = 0.5 / kTan36;

struct Place {
  double x, z;

  void fold() { z = std::abs(z); }
  /// Turned by an angle that is given by its cosine and sine.
  Place turned(double cos, double sin) const { return {x * cos - z * sin, z * cos + x * sin}; }
  Place operator-(const Place& other) const { return {x - other.x, z - other.z}; }
  Place operator*(double factor) const { return {x * factor, z * factor}; }
  /// From the line through (x0, 0) in the direction of that angle.
  double from_line(double x0, double cos, double sin) const { return std::abs(sin * (x - x0) - cos * z); }
};

/// Into the tenth of the plane next to the x axis, by the symmetries of a pentagon.
Place folded_by_fifths(Place place) {
  const double radius = std::sqrt(place.x * place.x + place.z * place.z);
  place.fold();
  if (place.x >= radius * kCos36) return place;
  place = place.x < -radius * kCos72 ? place.turned(-kCos36, -kSin36) : place.turned(kCos72, -kSin72);
  place.fold();
  return place;
}

/// Where there is nothing to be cut: in the middle, and where no number is.
bool is_nowhere(double x, double z) {
  constexpr double kNothing = 1e-10;
  const double radius = std::sqrt(x * x + z * z);
  return !(radius > kNothing && std::isfinite(radius));
}

/// How often a figure that reaches to `size` has to be cut, if each cut makes parts smaller by 1 / `factor`.
int cuts_for(double size, double factor) {
  return std::max(0, static_cast<int>(std::ceil(steady::logarithm(size) / steady::logarithm(factor))));
}

/// The border's value is `most`, and the value falls with the distances from it, not below `least`.
double part(double most, double distance1, double distance2, double least) {
  return std::max({most - distance1, most - distance2, least});
}

// ---- Kites and darts, rhombi: halves of both are cut into smaller ones ------------------------------------------------

/// A half kite has its ends at (0, 0), (1, 0) and (cos 36, sin 36); a half dart at (0, 0), (1, 0) and on its own side of
/// the x axis. Both are seen mirrored to positive z. `kite`: what `place` is in, of edges 1.
double in_triangles(Place place, bool kite, int depth, bool rhombi) {
  for (; depth > 0; --depth) {
    place.fold();
    const double beyond = place.x - 1.0 / kPhi;
    if (kite) {
      kite = place.z >= -beyond * kTan36;
      if (kite) place = (place - Place{kCos36, kSin36}).turned(-kCos72, kSin72);
    } else {
      kite = place.z < -beyond * kTan72;
      place = kite ? place.turned(kCos36, -kSin36) : (place - Place{1.0, 0.0}).turned(-kCos36, -kSin36);
    }
    place = place * kPhi;
  }
  place.fold();
  if (!rhombi) {
    constexpr double kSteepness = 4.46 / 2.0;
    const double outer = kite ? place.from_line(1.0, -kCos72, kSin72) : place.from_line(1.0, -kCos36, kSin36);
    const double inner = kite ? place.from_line(0.0, kCos36, kSin36) : place.z;
    return kite ? std::min(part(0.5, kSteepness * inner, kSteepness * outer, 0.0), 0.5 - kInside)
                : part(1.0, kSteepness * inner, kSteepness * outer, 0.5 + kInside);
  }
  constexpr double kSteepness = 5.55 / 2.0;
  const double cut = place.from_line(1.0 / kPhi, kCos72, kSin72);
  if (kite && place.z < (place.x - 1.0 / kPhi) * kTan72) {
    return part(1.0, kSteepness * cut, kSteepness * place.from_line(1.0, -kCos72, kSin72), 0.5 + kInside);
  }
  const double other = kite ? place.z : place.from_line(0.0, kCos36, kSin36);
  const double second = kite ? cut : place.from_line(1.0, -kCos36, kSin36);
  return std::min(part(0.5, kSteepness * other, kSteepness * second, 0.0), 0.5 - kInside);
}

double kites_or_rhombi(double x, double z, bool rhombi) {
  if (is_nowhere(x, z)) return 1.0;
  Place place = folded_by_fifths({x, z});
  if (rhombi) place = place * (1.0 / kPhi);
  const int pairs = cuts_for(place.from_line(0.0, -kCos72, kSin72) / kCos18, kPhi2);
  place = place * steady::power(1.0 / kPhi2, pairs);
  if (pairs % 2 != 0) place = place.turned(kCos36, -kSin36);
  return in_triangles(place, true, 2 * pairs, rhombi);
}

// ---- Pentagons, stars, boats, diamonds --------------------------------------------------------------------------------

/// Kinds of tiles; the numbers are the parts of the value.
enum class Tile { pentagon1, pentagon2, pentagon3, star, boat, diamond };

/// Where a point lies: in a tile about the origin, mirrored to positive z. `marked` tells two places of one kind of
/// tile apart: of the second pentagon the quadrangle that is cut off, of the third and of the boat the wedge towards a
/// neighbour, of the diamond the half at its begin.
struct Whereabouts {
  Place place;
  Tile tile;
  bool marked;
};

/// The same in the tiles that the tile is cut into, which are smaller by kPhi.
Whereabouts cut(const Whereabouts& from) {
  Place place = from.place;
  place.fold();
  const Place backwards{-place.x, place.z};
  switch (from.tile) {
    case Tile::pentagon1:
      place = folded_by_fifths(place);
      if (place.z < (place.x - kInnerRadius) * kTan54 + 0.5) {
        return {place - Place{kInnerRadius + kRadius * kCos72 / kPhi, 0.0}, Tile::pentagon2, false};
      }
      return {place.turned(kCos36, -kSin36), Tile::star, false};
    case Tile::pentagon2:
      if (from.marked) {
        const double beyond = place.x - kRadius / kPhi2;
        if (place.z < beyond * kTan54) return {place - Place{kRadius, 0.0}, Tile::pentagon1, false};
        if (place.z < -beyond * kTan18) return {backwards, Tile::diamond, true};
        return {place.turned(-kCos72, kSin72) - Place{-kRadius / kPhi, 0.0}, Tile::pentagon2, true};
      }
      if (place.z < (place.x + kRadius) * kTan18) {
        return {place - Place{kRadius / kPhi2 - kRadius, 0.0}, Tile::diamond, false};
      }
      place = place.turned(kCos36, -kSin36);
      return {Place{-place.x - kRadius * kCos72, place.z - kRadius * kSin72}, Tile::pentagon3, false};
    case Tile::pentagon3:
      if (from.marked && place.x > kRadius * kCos72 / kPhi2) {
        return {Place{kRadius * kCos72 / kPhi2 + kInnerRadius / kPhi - place.x, place.z}, Tile::pentagon2, true};
      }
      if (!from.marked && place.x < -kRadius * kCos72) {
        return {place.turned(-kCos36, -kSin36) - Place{kRadius, 0.0}, Tile::pentagon2, false};
      }
      if (!from.marked && place.z > -(place.x - kRadius / kPhi2) * kTan54) {
        place = place.turned(kCos36, kSin36);
        return {Place{-place.x - kRadius * kCos72, place.z - kRadius * kSin72}, Tile::pentagon3, false};
      }
      return {place, Tile::boat, from.marked};
    case Tile::star:
      if (place.x < kInnerRadius / kPhi) return {place, Tile::pentagon1, false};
      return {Place{2.0 * kInnerRadius / kPhi - place.x, place.z}, Tile::pentagon3, true};
    case Tile::boat:
      if (from.marked && place.x > -kPhi * kRadius * kCos72) return {backwards, Tile::pentagon1, false};
      if (!from.marked) place = place.turned(kCos72, kSin72);
      return {place - Place{-kRadius, 0.0}, Tile::pentagon3, true};
    case Tile::diamond:
      break;
  }
  return {place, from.marked ? Tile::pentagon1 : Tile::pentagon3, !from.marked};
}

/// From the nearest border of the tile.
double from_border(const Whereabouts& at) {
  Place place = at.place;
  place.fold();
  const auto from_point_of_star = [](Place of) { return of.from_line(kPhi * kRadius, -kCos18, kSin18); };
  switch (at.tile) {
    case Tile::pentagon1:
    case Tile::pentagon2:
    case Tile::pentagon3:
      return std::abs(folded_by_fifths(place).x - kInnerRadius);
    case Tile::star:
      return from_point_of_star(place);
    case Tile::boat:
      return std::min(std::abs(place.x - kRadius * kCos72 / kPhi),
                      from_point_of_star(folded_by_fifths({-place.x, place.z})));
    case Tile::diamond:
      break;
  }
  return place.from_line(-kRadius / kPhi, kCos18, kSin18);
}

}  // namespace

double penrose_kites(double x, double z) { return kites_or_rhombi(x, z, false); }
double penrose_rhombi(double x, double z) { return kites_or_rhombi(x, z, true); }

double penrose_pentagons(double x, double z) {
  constexpr double kKinds = 6.0;
  if (is_nowhere(x, z)) return 1.0;
  const Place place = folded_by_fifths({x, z});
  const int fours = cuts_for(place.x * 2.0 * kTan36, kPhi2 * kPhi2);
  Whereabouts at{place * steady::power(1.0 / (kPhi2 * kPhi2), fours), Tile::pentagon1, false};
  for (int i = 0; i < 4 * fours; ++i) {
    at = cut(at);
    at.place = at.place * kPhi;
  }
  const double kind = static_cast<double>(at.tile);
  const double least = kind > 0.0 ? kind / kKinds + kInside : 0.0;
  return std::clamp((kind + 1.0 - from_border(at) * 5.55 / kPhi) / kKinds, least, (kind + 1.0) / kKinds - kInside);
}

}  // namespace firstlight::render
