#include "render/surface/texture_function.h"

#include "render/surface/compiled_pigment.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace firstlight::render {
namespace {

/// About what a pattern costs, in instructions of a program.
constexpr std::uint64_t kPatternCost = 100;

FeatureUses uses_of(const Patterning& pattern) {
  FeatureUses uses;
  gather(pattern, uses);
  return uses;
}

FeatureUses uses_of(const Pigment& pigment) {
  FeatureUses uses;
  gather(pigment, uses);
  return uses;
}

/// Pre: `points` has its size.
void take_points(const double* const* arguments, std::size_t begin, SurfacePoints& points) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy_n(arguments[axis] + begin, points.size, points.at.of[axis].at.begin());
  }
}

class PatternFunction final : public Function {
 public:
  PatternFunction(Patterning pattern, const PatternWorld& world)
      : Function(3, 1, kPatternCost, pattern.depth + 1, uses_of(pattern)), pattern_(std::move(pattern)), compiled_(pattern_, world) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    *results = 0.0;
    if (!compiled_.has_places() || !unrendered().empty()) return;
    SurfacePoints points;
    points.size = 1;
    points.at.set(0, Vec3(arguments[0], arguments[1], arguments[2]));
    Columns3<double> there;
    Column<double> place;
    compiled_.to_pattern(points, there);
    compiled_.places(there, points, place);
    *results = place[0];
  }
  void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                     Evaluation&) const override {
    std::fill_n(results[0], count, 0.0);
    if (!compiled_.has_places() || !unrendered().empty()) return;
    SurfacePoints points;
    for (std::size_t begin = 0; begin < count; begin += kRaysAtOnce) {
      points.size = std::min(kRaysAtOnce, count - begin);
      take_points(arguments, begin, points);
      Columns3<double> there;
      Column<double> place;
      compiled_.to_pattern(points, there);
      compiled_.places(there, points, place);
      std::copy_n(place.at.begin(), points.size, results[0] + begin);
    }
  }

 private:
  Patterning pattern_;
  CompiledPattern compiled_;
};

class PigmentFunction final : public Function {
 public:
  PigmentFunction(Pigment pigment, const PatternWorld& world)
      : Function(3, 5, kPatternCost, pigment.pattern->depth + 1, uses_of(pigment)), pigment_(std::move(pigment)), compiled_(pigment_, world) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    std::fill_n(results, result_count(), 0.0);
    if (!unrendered().empty()) return;
    const FilteredColor color = compiled_.color_at({arguments[0], arguments[1], arguments[2]});
    results[0] = color.rgb.x;
    results[1] = color.rgb.y;
    results[2] = color.rgb.z;
    results[3] = color.filter;
    results[4] = color.transmit;
  }
  void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                     Evaluation& evaluation) const override {
    if (!unrendered().empty() || compiled_.is_plain()) return Function::evaluate_many(arguments, results, count, evaluation);
    SurfacePoints points;
    ColorColumns colors;
    for (std::size_t begin = 0; begin < count; begin += kRaysAtOnce) {
      points.size = std::min(kRaysAtOnce, count - begin);
      take_points(arguments, begin, points);
      compiled_.colors(points, colors);
      for (std::size_t c = 0; c < 3; ++c) {
        std::copy_n(colors.rgb.of[c].at.begin(), points.size, results[c] + begin);
      }
      std::copy_n(colors.filter.at.begin(), points.size, results[3] + begin);
      std::copy_n(colors.transmit.at.begin(), points.size, results[4] + begin);
    }
  }

 private:
  Pigment pigment_;
  CompiledPigment compiled_;
};

}  // namespace

FunctionPtr make_pattern_function(Patterning pattern, const PatternWorld& world) {
  return std::make_shared<PatternFunction>(std::move(pattern), world);
}
FunctionPtr make_pigment_function(Pigment pigment, const PatternWorld& world) {
  return std::make_shared<PigmentFunction>(std::move(pigment), world);
}

}  // namespace firstlight::render
