#include "render/lanes/math.h"

#include "render/lanes/math-inl.h"

namespace firstlight::render {

double exponential(double x) { return HWY_NAMESPACE::exponential(One(x)).v; }
double logarithm(double x) { return HWY_NAMESPACE::logarithm(One(x)).v; }
double power(double x, double y) { return HWY_NAMESPACE::power(One(x), One(y)).v; }
double sine(double x) { return HWY_NAMESPACE::sine(One(x)).v; }
double cosine(double x) { return HWY_NAMESPACE::cosine(One(x)).v; }
double tangent(double x) { return HWY_NAMESPACE::tangent(One(x)).v; }
double arc_sine(double x) { return HWY_NAMESPACE::arc_sine(One(x)).v; }
double arc_cosine(double x) { return HWY_NAMESPACE::arc_cosine(One(x)).v; }
double arc_tangent(double x) { return HWY_NAMESPACE::arc_tangent(One(x)).v; }
double arc_tangent(double y, double x) { return HWY_NAMESPACE::arc_tangent(One(y), One(x)).v; }

}  // namespace firstlight::render
