#pragma once

namespace firstlight::render::steady {

// The elementary functions of math-inl.h for single numbers: what shapes a picture uses them instead of <cmath>, whose last
// digits depend on the machine. Special cases are the same.

double exponential(double x);
double logarithm(double x);
double power(double x, double y);
double sine(double x);
double cosine(double x);
double tangent(double x);
double arc_sine(double x);
double arc_cosine(double x);
double arc_tangent(double x);
/// The angle of (x, y) from the x axis.
double arc_tangent(double y, double x);

double hyperbolic_sine(double x);
double hyperbolic_cosine(double x);
double hyperbolic_tangent(double x);
double hyperbolic_arc_sine(double x);
double hyperbolic_arc_cosine(double x);
double hyperbolic_arc_tangent(double x);
double decimal_logarithm(double x);

}  // namespace firstlight::render::steady
