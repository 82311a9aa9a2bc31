#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/render/hypercomplex_test.cpp"
#include <hwy/foreach_target.h>

#include "render/shape/hypercomplex-inl.h"

#if HWY_ONCE
#include "tests/render/field_test_support.h"

#include <array>
#include <complex>
#include <utility>

namespace firstlight::render {
namespace {

namespace lanes = HWY_NAMESPACE;
using Hyper = lanes::Vec4Of<One>;
using Complex = std::complex<double>;

std::array<Complex, 2> parts(const Hyper& a) {
  return {Complex(a.x.v - a.w.v, a.y.v + a.z.v), Complex(a.x.v + a.w.v, a.y.v - a.z.v)};
}

TEST(Hypercomplex, IsTwoComplexNumbers) {
  RayRain rain(6);
  const auto any = [&] {
    const Vec3 p = rain.point(2.0);
    return Hyper{p.x, p.y, p.z, rain.point(2.0).x};
  };
  const Hyper none{7.0, 7.0, 7.0, 7.0};
  for (int i = 0; i < 200; ++i) {
    const Hyper a = any();
    const Hyper b = any();
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(std::abs(parts(lanes::hyper_product(a, b))[k] - parts(a)[k] * parts(b)[k]), 0.0, 1e-12);
      EXPECT_NEAR(std::abs(parts(lanes::hyper_square(a))[k] - parts(a)[k] * parts(a)[k]), 0.0, 1e-12);
      EXPECT_NEAR(std::abs(parts(lanes::hyper_reciprocal(a, none))[k] * parts(a)[k] - 1.0), 0.0, 1e-9);
    }
  }
  EXPECT_EQ(lanes::hyper_reciprocal(Hyper{1.0, 0.0, 0.0, 1.0}, none).x.v, 7.0);
}

TEST(Hypercomplex, FunctionsUndoTheirArcFunctions) {
  const std::pair<JuliaFunction, JuliaFunction> pairs[] = {
      {JuliaFunction::sine, JuliaFunction::arc_sine},
      {JuliaFunction::hyperbolic_sine, JuliaFunction::hyperbolic_arc_sine},
      {JuliaFunction::hyperbolic_cosine, JuliaFunction::hyperbolic_arc_cosine},
      {JuliaFunction::cosine, JuliaFunction::arc_cosine},
      {JuliaFunction::tangent, JuliaFunction::arc_tangent},
      {JuliaFunction::hyperbolic_tangent, JuliaFunction::hyperbolic_arc_tangent},
      {JuliaFunction::exponential, JuliaFunction::natural_logarithm},
  };
  const auto value = [](JuliaFunction function, const Complex& z, const Complex& exponent) {
    const auto result = lanes::complex_function(function, exponent, lanes::ComplexOf<One>{z.real(), z.imag()});
    return Complex(result.real.v, result.imag.v);
  };
  for (const auto& [function, arc] : pairs) {
    for (const Complex z : {Complex(0.3, 0.4), Complex(-0.6, 0.2), Complex(0.5, -0.7)}) {
      const Complex back = value(function, value(arc, z, {}), {});
      EXPECT_NEAR(std::abs(back - z), 0.0, 1e-12) << static_cast<int>(function) << " " << z;
    }
  }
  const Complex power = value(JuliaFunction::power, {0.3, 0.4}, {2.0, 0.5});
  EXPECT_NEAR(std::abs(power - std::pow(Complex(0.3, 0.4), Complex(2.0, 0.5))), 0.0, 1e-12);
}

}  // namespace
}  // namespace firstlight::render
#endif
