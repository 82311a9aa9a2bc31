#pragma once

#include "app/compare/record.h"
#include "app/compare/settings.h"
#include "render/image/picture.h"

#include <optional>

namespace firstlight::app::compare {

/// A pixel agrees when no channel differs by more than this, of 255.
inline constexpr int kTolerance = 2;

/// How far `second` is from `first`, which FLIP takes for the reference. Pre: equal sizes, at least one pixel.
PictureDifference difference(const render::Picture& first, const render::Picture& second, int tolerance = kTolerance);

/// The difference of each channel, 16 times as strong, so that a single step can be seen. Pre: equal sizes.
render::Picture difference_map(const render::Picture& first, const render::Picture& second);

/// The FLIP error of each pixel: black where there is none, over violet and orange to pale yellow. Pre: equal sizes.
render::Picture flip_map(const render::Picture& first, const render::Picture& second);

/// Status::agrees, warns or differs.
Status judge(const PictureDifference& difference, const Thresholds& thresholds);

}  // namespace firstlight::app::compare
