#pragma once

#include "app/study/curve.h"

#include <span>
#include <string>
#include <vector>

namespace firstlight::app {

struct PlotLine {
  std::string name;
  /// Which of the page's line styles: CSS classes line0, line1 ...
  int style = 0;
  std::vector<CurvePoint> points;
};

/// Lines in a frame with two axes, as an SVG element without colours of its own: the page's style sheet gives them, so
/// the same picture suits light and dark pages.
struct Plot {
  enum class Numbers { plain, percent };
  enum class Scale { linear, logarithmic };

  std::string title;
  std::string x_label;
  std::string y_label;
  Numbers x_numbers = Numbers::plain;
  Numbers y_numbers = Numbers::plain;
  Scale y_scale = Scale::linear;
  double x_most = 0.0;   ///< 0: as far as the lines go
  double y_most = 0.0;   ///< 0: as far as the lines go
  double y_least = 0.0;  ///< of a logarithmic scale; smaller values lie on the floor
  int width = 560;       ///< in units of the picture, which grows with the page
  int height = 320;
  std::vector<PlotLine> lines;
};

std::string to_svg(const Plot& plot);

/// Where an axis from 0 to `most` has its marks: multiples of 1, 2 or 5 times a power of ten, `wanted` or a few less.
std::vector<double> axis_marks(double most, int wanted);
/// "1.5 M", "20", "0.25": as short as marks can be.
std::string axis_number(double value, Plot::Numbers numbers);

/// For text between tags and in quoted attributes.
std::string escape_html(std::string_view text);

}  // namespace firstlight::app
