#pragma once

#include "render/texture/pattern.h"

#include <memory>
#include <utility>

namespace firstlight::render {

/// A pattern that is a plain function of the point.
template <class Function>
class Field final : public Pattern {
 public:
  explicit Field(Function function) : function_(std::move(function)) {}
  double value(const Vec3& point) const override { return function_(point); }

 private:
  Function function_;
};

template <class Function>
std::shared_ptr<const Pattern> make_field(Function function) {
  return std::make_shared<Field<Function>>(std::move(function));
}

}  // namespace firstlight::render
