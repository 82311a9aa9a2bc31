#pragma once

#include "render/math/columns.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace firstlight::render {

constexpr std::size_t kMostOrder = 40;

/// A part of a curve that is still to be looked at, and the curve's values at its ends.
struct CurvePart {
  double begin, end;
  double at_begin, at_end;
};

/// Real roots of c[0] + c[1] x + c[2] x^2 + ... in [low, high], ascending, one after the other: who wants only the first
/// pays only for it. Roots where the curve only touches zero without changing sign are left out.
///
/// Source   On an interval the curve lies in the hull of its Bernstein coefficients. If none of them changes sign there is
///          no root, if one does there is one, and else the interval is halved. [Lane and Riesenfeld, Bounds on a Polynomial,
///          1981] The coefficients are found anew of each interval, so they are as good as the curve's values there. No
///          root is lost or invented by cancellation, as happens to the closed formulas of Ferrari and Cardano: each
///          end of an interval has one sign. That a quartic has no root at all its discriminant says.
///          Roots of lines and parabolas are found in closed form between ends of two signs, or on both sides of a vertex.
/// Cost     Bounded: roots that cannot be told apart after kMostHalvings count as one or as none.
class PolynomialRoots {
 public:
  static constexpr int kMostHalvings = 96;

  /// Pre: `c` outlives the search and has at most kMostOrder + 1 coefficients.
  PolynomialRoots(std::span<const double> c, double low, double high) : c_(c) {
    if (c.size() > 1 && low < high) waiting_[waiting_count_++] = {low, high, 0.0, 0.0};  // values: when it is looked at
  }

  /// The next root. False: there is none.
  bool next(double& root);

 private:
  template <class Order>
  bool next(Order order, double& root);
  bool next_of_few(double& root);

  std::span<const double> c_;
  int halvings_left_ = kMostHalvings;
  std::size_t waiting_count_ = 0;
  std::array<CurvePart, kMostHalvings + 1> waiting_;  ///< the first one last
};

/// Polynomials of one order side by side, each with an interval in which its roots are looked for.
struct PolynomialColumns {
  std::size_t order = 0;  ///< from 1 to kMostOrder
  std::array<Column<double>, kMostOrder + 1> c;
  Column<double> low, high;
};

/// Their roots: of each those, to the bit, that PolynomialRoots finds of it alone.
class RootColumns {
 public:
  /// Pre: `polynomials` outlive the search, and low < high of those in `who`.
  RootColumns(const PolynomialColumns& polynomials, std::uint64_t who);

  /// Finds the next root of each in `who`, and returns the bits of those that have one.
  /// Pre: they were in the constructor's `who`.
  std::uint64_t next(std::uint64_t who, Column<double>& root);

  struct Search {
    Column<double> first, second;  ///< of lines and parabolas: all their roots
    std::uint64_t has_first, has_second;
    std::array<std::array<CurvePart, PolynomialRoots::kMostHalvings + 1>, kRaysAtOnce> waiting;  ///< the first one last
    std::array<std::uint8_t, kRaysAtOnce> waiting_count;
    std::array<std::uint8_t, kRaysAtOnce> halvings_left;
  };

 private:
  std::uint64_t next_of_few(std::uint64_t who, Column<double>& root);
  /// That of the calling thread: one search at a time.
  static Search& of_thread();

  const PolynomialColumns* polynomials_;
  Search* search_;
};

/// No root is farther from 0. [Fujiwara, 1916; up to 1.2 times that]
/// Pre: the last coefficient is not 0.
double root_bound(std::span<const double> c);

}  // namespace firstlight::render
