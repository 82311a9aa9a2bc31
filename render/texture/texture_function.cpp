#include "render/texture/texture_function.h"

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

class PatternFunction final : public Function {
 public:
  explicit PatternFunction(Patterning pattern)
      : Function(3, 1, kPatternCost, pattern.depth + 1, uses_of(pattern)), pattern_(std::move(pattern)) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    const bool known = pattern_.field && unrendered().empty();
    const Vec3 point(arguments[0], arguments[1], arguments[2]);
    *results = known ? shaped(pattern_.wave, value_at(pattern_, point)) : 0.0;
  }

 private:
  Patterning pattern_;
};

class PigmentFunction final : public Function {
 public:
  explicit PigmentFunction(Pigment pigment)
      : Function(3, 5, kPatternCost, pigment.pattern->depth + 1, uses_of(pigment)), pigment_(std::move(pigment)) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    std::fill_n(results, result_count(), 0.0);
    if (!unrendered().empty()) return;
    const FilteredColor color = color_at(pigment_, {arguments[0], arguments[1], arguments[2]});
    results[0] = color.rgb.x;
    results[1] = color.rgb.y;
    results[2] = color.rgb.z;
    results[3] = color.filter;
    results[4] = color.transmit;
  }

 private:
  Pigment pigment_;
};

}  // namespace

FunctionPtr make_pattern_function(Patterning pattern) { return std::make_shared<PatternFunction>(std::move(pattern)); }
FunctionPtr make_pigment_function(Pigment pigment) { return std::make_shared<PigmentFunction>(std::move(pigment)); }

}  // namespace firstlight::render
