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

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) values[i] = function_(at.vector(i));
  }

 private:
  Function function_;
};

template <class Function>
std::shared_ptr<const Pattern> make_field(Function function) {
  return std::make_shared<Field<Function>>(std::move(function));
}

/// The same that tilts normals in a way of its own: tilt(point, tilting) is what is added to the normal.
template <class Function, class Tilt>
class TiltingField final : public Pattern {
 public:
  TiltingField(Function function, Tilt tilt) : function_(std::move(function)), tilt_(std::move(tilt)) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    for (std::size_t i = 0; i < points.size; ++i) values[i] = function_(at.vector(i));
  }
  bool has_tilt() const override { return true; }
  void tilt(const Tilting& tilting, const Columns3<double>& at, const SurfacePoints& points,
            Columns3<double>& normals) const override {
    for (std::size_t i = 0; i < points.size; ++i) normals.set(i, normals.vector(i) + tilt_(at.vector(i), tilting));
  }

 private:
  Function function_;
  Tilt tilt_;
};

template <class Function, class Tilt>
std::shared_ptr<const Pattern> make_field(Function function, Tilt tilt) {
  return std::make_shared<TiltingField<Function, Tilt>>(std::move(function), std::move(tilt));
}

}  // namespace firstlight::render
