#include "render/texture/default_map.h"

namespace firstlight::render {
namespace {

ColorMapEntry at(double position, float red, float green, float blue) {
  return {position, {Rgb(red, green, blue), 0.0f, 0.0f}};
}

const ColorMap kGrey = {at(0, 0, 0, 0), at(1, 1, 1, 1)};
const ColorMap kChecker = {at(0, 0, 0, 1), at(1, 0, 1, 0)};
const ColorMap kHexagon = {at(0, 0, 0, 1), at(1, 0, 1, 0), at(2, 1, 0, 0)};
const ColorMap kSquare = {at(0, 1, 0, 0), at(1, 0, 1, 0), at(2, 0, 0, 1), at(3, 1, 1, 0)};
const ColorMap kCubic = {at(0, 1, 0, 0), at(1, 0, 1, 0), at(2, 0, 0, 1),
                         at(3, 1, 1, 0), at(4, 0, 1, 1), at(5, 1, 0, 1)};
const ColorMap kBrick = {at(0, 0.5f, 0.5f, 0.5f), at(1, 0.6f, 0.15f, 0.15f)};
const ColorMap kBozo = {at(0.4, 1, 1, 1), at(0.4, 0, 1, 0), at(0.6, 0, 1, 0),
                        at(0.6, 0, 0, 1), at(0.8, 0, 0, 1), at(0.8, 1, 0, 0)};
const ColorMap kWood = {at(0.6, 0.666f, 0.312f, 0.2f), at(0.6, 0.4f, 0.1333f, 0.066f)};
const ColorMap kMandel = {at(0.001, 0, 0, 0), at(0.001, 0, 1, 1), at(0.012, 1, 1, 0), at(0.015, 1, 0, 1),
                          at(0.1, 0, 1, 1)};
const ColorMap kAgate = {at(0.0, 1, 1, 1),          at(0.5, 0.95f, 0.75f, 0.5f), at(0.5, 0.9f, 0.7f, 0.5f),
                         at(0.6, 0.9f, 0.7f, 0.4f), at(0.6, 1, 0.7f, 0.4f),      at(1.0, 0.6f, 0.3f, 0)};
const ColorMap kRadial = {at(0, 0, 1, 1), at(0.333, 1, 1, 0), at(0.666, 1, 0, 1), at(1, 0, 1, 1)};
const ColorMap kMarble = {at(0, 0.9f, 0.8f, 0.8f), at(0.9, 0.9f, 0.08f, 0.08f), at(0.9, 0, 0, 0)};

}  // namespace

const ColorMap& default_map(const Patterning& pattern) {
  switch (pattern.kind) {
    case PatternKind::agate:
      return kAgate;
    case PatternKind::bozo:
      return kBozo;
    case PatternKind::brick:
      return kBrick;
    case PatternKind::checker:
    case PatternKind::object:
      return kChecker;
    case PatternKind::cubic:
    case PatternKind::triangular:
      return kCubic;
    case PatternKind::hexagon:
      return kHexagon;
    case PatternKind::mandel: {
      const auto* fractal = std::get_if<FractalParameters>(&pattern.parameters);
      return fractal == nullptr || fractal->exponent == 2 ? kMandel : kGrey;
    }
    case PatternKind::marble:
      return kMarble;
    case PatternKind::radial:
      return kRadial;
    case PatternKind::square:
      return kSquare;
    case PatternKind::wood:
      return kWood;
    default:
      return kGrey;
  }
}

}  // namespace firstlight::render
