#include "render/lanes/math.h"

#include "render/lanes/hyperbolic-inl.h"

namespace firstlight::render::steady {

double exponential(double x) { return render::HWY_NAMESPACE::exponential(One(x)).v; }
double logarithm(double x) { return render::HWY_NAMESPACE::logarithm(One(x)).v; }
double power(double x, double y) { return render::HWY_NAMESPACE::power(One(x), One(y)).v; }
double sine(double x) { return render::HWY_NAMESPACE::sine(One(x)).v; }
double cosine(double x) { return render::HWY_NAMESPACE::cosine(One(x)).v; }
double tangent(double x) { return render::HWY_NAMESPACE::tangent(One(x)).v; }
double arc_sine(double x) { return render::HWY_NAMESPACE::arc_sine(One(x)).v; }
double arc_cosine(double x) { return render::HWY_NAMESPACE::arc_cosine(One(x)).v; }
double arc_tangent(double x) { return render::HWY_NAMESPACE::arc_tangent(One(x)).v; }
double arc_tangent(double y, double x) { return render::HWY_NAMESPACE::arc_tangent(One(y), One(x)).v; }
double hyperbolic_sine(double x) { return render::HWY_NAMESPACE::hyperbolic_sine(One(x)).v; }
double hyperbolic_cosine(double x) { return render::HWY_NAMESPACE::hyperbolic_cosine(One(x)).v; }
double hyperbolic_tangent(double x) { return render::HWY_NAMESPACE::hyperbolic_tangent(One(x)).v; }
double hyperbolic_arc_sine(double x) { return render::HWY_NAMESPACE::hyperbolic_arc_sine(One(x)).v; }
double hyperbolic_arc_cosine(double x) { return render::HWY_NAMESPACE::hyperbolic_arc_cosine(One(x)).v; }
double hyperbolic_arc_tangent(double x) { return render::HWY_NAMESPACE::hyperbolic_arc_tangent(One(x)).v; }
double decimal_logarithm(double x) { return render::HWY_NAMESPACE::decimal_logarithm(One(x)).v; }

}  // namespace firstlight::render::steady
