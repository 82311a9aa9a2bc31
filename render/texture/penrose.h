#pragma once

namespace firstlight::render {

// Penrose's tilings of the x-z plane, which repeat nowhere. A value from 0 to 1: each kind of tile has an equal part of
// it, whose highest value is at the tile's border. [POV-Ray 3.7's tilings 25 to 27; Penrose 1974; Robinson's triangles as in
// Gruenbaum & Shephard, "Tilings and Patterns", chapter 10]

/// Pentagons of three kinds, stars, boats and diamonds, around a pentagon.
double penrose_pentagons(double x, double z);
/// Kites and darts, around a star of darts.
double penrose_kites(double x, double z);
/// Narrow and wide rhombi, around a star of wide ones.
double penrose_rhombi(double x, double z);

}  // namespace firstlight::render
