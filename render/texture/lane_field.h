#pragma once

#include "render/texture/patterns.h"

#include <memory>
#include <utility>

namespace firstlight::render {

/// A pattern whose formula is written over a lane type: `Formula` holds its numbers, and functions that are dispatched to the
/// machine's instruction set evaluate it for blocks of points (lane_field-inl.h). `tilts` is null where the pattern does not
/// tilt normals in a way of its own.
template <class Formula>
class LaneField final : public Pattern {
 public:
  using Values = void (*)(const Formula&, const Columns3<double>& at, std::size_t count, Column<double>& values);
  using Tilts = void (*)(const Formula&, const Tilting& tilting, const Columns3<double>& at, std::size_t count,
                         Columns3<double>& normals);

  LaneField(Formula formula, Values values, Tilts tilts)
      : formula_(std::move(formula)), values_(values), tilts_(tilts) {}

  void values(const Columns3<double>& at, const SurfacePoints& points, Column<double>& values) const override {
    values_(formula_, at, points.size, values);
  }
  bool has_tilt() const override { return tilts_ != nullptr; }
  void tilt(const Tilting& tilting, const Columns3<double>& at, const SurfacePoints& points,
            Columns3<double>& normals) const override {
    tilts_(formula_, tilting, at, points.size, normals);
  }

 private:
  Formula formula_;
  Values values_;
  Tilts tilts_;
};

template <class Formula>
PatternPtr make_lane_field(Formula formula, typename LaneField<Formula>::Values values,
                           typename LaneField<Formula>::Tilts tilts = nullptr) {
  return std::make_shared<LaneField<Formula>>(std::move(formula), values, tilts);
}

}  // namespace firstlight::render
