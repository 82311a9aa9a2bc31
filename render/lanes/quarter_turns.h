#pragma once

namespace firstlight::render {

/// An angle as a whole number of quarter turns and a rest.
struct QuarterTurns {
  int count;    ///< 0 to 3: whole turns are left out
  double rest;  ///< radians, at most an eighth of a turn to either side
  double low;   ///< what is to be added to it, below its last digit
};

/// Reduces an angle in radians of any size. The rest of an infinite one, or of what is no number, is no number.
/// Source   M. Payne & R. Hanek, "Radian reduction for trigonometric functions", SIGNUM Newsletter 18, 1983.
QuarterTurns quarter_turns(double angle);

}  // namespace firstlight::render
