#include "render/function/transform_function.h"

#include <memory>

namespace firstlight::render {
namespace {

class TransformFunction final : public Function {
 public:
  explicit TransformFunction(const Transform& transform) : Function(3, 3), transform_(transform) {}
  void evaluate(const double* arguments, double* results, Evaluation&) const override {
    const Vec3 there = transform_.point({arguments[0], arguments[1], arguments[2]});
    for (int axis = 0; axis < 3; ++axis) results[axis] = there[axis];
  }

 private:
  Transform transform_;
};

}  // namespace

FunctionPtr make_transform_function(const Transform& transform) {
  return std::make_shared<TransformFunction>(transform);
}

}  // namespace firstlight::render
