#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace firstlight::render {

/// Real roots of c[0] + c[1] x + c[2] x^2 + c[3] x^3 + c[4] x^4 in [low, high], ascending; returns how many. Roots
/// where the curve only touches zero without changing sign are left out.
///
/// Between two neighbouring extrema a polynomial is monotone, so each sign change brackets exactly one root; the
/// extrema are the roots of the derivative, found the same way. No root is lost or invented by cancellation, as happens
/// to the closed formulas of Ferrari and Cardano. [Yuksel, High-Performance Polynomial Root Finding for Graphics, 2022]
int quartic_roots(const std::array<double, 5>& c, double low, double high, std::array<double, 4>& roots);

/// The same for c[0] + c[1] x + c[2] x^2 + c[3] x^3.
int cubic_roots(const std::array<double, 4>& c, double low, double high, std::array<double, 3>& roots);

/// The same for c[0] + c[1] x + ... of any order up to kMostOrder. Pre: `roots` has room for as many as the order.
constexpr std::size_t kMostOrder = 40;
std::size_t polynomial_roots(std::span<const double> c, double low, double high, std::span<double> roots);

/// The same in [0, 1], faster for high orders with few roots: by signs of Bernstein's coefficients, as many of which change
/// as there are roots, or an even number more. An interval with one change has one root; others are halved.
/// [Lane, Riesenfeld 1981, "Bounds on a polynomial"]
/// Pre: the order is at most kMostBernsteinOrder.
constexpr std::size_t kMostBernsteinOrder = 12;
std::size_t bernstein_roots(std::span<const double> c, std::span<double> roots);

}  // namespace firstlight::render
