#pragma once

#include "render/math/vec.h"

namespace firstlight::render {

// Chance that belongs to the cells of the lattice of whole numbers, the same in every run. Values are POV-Ray 3.7's.

/// A number from 0 to 4095 of a cell, given by its lowest corner; cells 4096 apart have the same.
unsigned cell_hash(double x, double y, double z);
/// Number `index` of a fixed row of random numbers in [0, 1): the Mersenne Twister's with its usual seed. Pre: index < 4100.
double table_random(unsigned index);
/// A random point in the cell whose lowest corner is `corner`.
Vec3 point_in_cell(const Vec3& corner);

}  // namespace firstlight::render
