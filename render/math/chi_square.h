#pragma once

namespace firstlight::render {

/// The number that a sum of squares of `degrees` independent standard normal variables exceeds with the probability `tail`.
/// Pre: degrees >= 1, 0 < tail < 1.
///
/// Accuracy 1e-10, relative, up to 100,000 degrees.
/// Cost     some hundred steps; grows with the root of the degrees.
/// Source   Abramowitz & Stegun, "Handbook of Mathematical Functions", 6.5.29, 6.5.31, 26.4.17.
double chi_square_quantile(int degrees, double tail);

}  // namespace firstlight::render
