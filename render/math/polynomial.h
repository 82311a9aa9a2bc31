#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace firstlight::render {

constexpr std::size_t kMostOrder = 40;

/// Real roots of c[0] + c[1] x + c[2] x^2 + ... in [low, high], ascending, one after the other: who wants only the first
/// pays only for it. Roots where the curve only touches zero without changing sign are left out.
///
/// Source   On an interval the curve lies in the hull of its Bernstein coefficients. If none of them changes sign there is
///          no root, if one does there is one, and else the interval is halved. [Lane and Riesenfeld, Bounds on a Polynomial,
///          1981] The coefficients are found anew of each interval, so they are as good as the curve's values there. No
///          root is lost or invented by cancellation, as happens to the closed formulas of Ferrari and Cardano: each
///          end of an interval has one sign.
/// Cost     Bounded: roots that cannot be told apart after kMostHalvings count as one or as none.
class PolynomialRoots {
 public:
  /// Pre: `c` outlives the search and has at most kMostOrder + 1 coefficients.
  PolynomialRoots(std::span<const double> c, double low, double high);

  /// The next root. False: there is none.
  bool next(double& root);

 private:
  static constexpr int kMostHalvings = 96;

  struct Interval {
    double begin, end;
    double at_begin, at_end;  ///< values
  };

  template <class Order>
  bool next(Order order, double& root);

  std::span<const double> c_;
  int halvings_left_ = kMostHalvings;
  std::size_t waiting_count_ = 0;
  std::array<Interval, kMostHalvings + 1> waiting_;  ///< the first one last
};

/// No root is farther from 0. [Fujiwara, 1916; rounded up to a power of 2]
/// Pre: the last coefficient is not 0.
double root_bound(std::span<const double> c);

}  // namespace firstlight::render
