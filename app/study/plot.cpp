#include "app/study/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace firstlight::app {
namespace {

// Room around the frame, for the numbers and the labels.
constexpr double kLeft = 64.0;
constexpr double kRight = 16.0;
constexpr double kTop = 12.0;
constexpr double kBottom = 46.0;

/// Takes values into the frame.
class Frame {
 public:
  explicit Frame(const Plot& plot) : plot_(plot), x_most_(plot.x_most), y_most_(plot.y_most) {
    for (const PlotLine& line : plot.lines) {
      for (const CurvePoint& point : line.points) {
        if (plot.x_most == 0.0) x_most_ = std::max(x_most_, point.x);
        if (plot.y_most == 0.0) y_most_ = std::max(y_most_, point.y);
      }
    }
    if (x_most_ <= 0.0) x_most_ = 1.0;
    if (y_most_ <= 0.0) y_most_ = 1.0;
  }

  double left() const { return kLeft; }
  double right() const { return plot_.width - kRight; }
  double top() const { return kTop; }
  double bottom() const { return plot_.height - kBottom; }
  double x_most() const { return x_most_; }
  double y_most() const { return y_most_; }

  double x(double value) const { return left() + (right() - left()) * std::clamp(value / x_most_, 0.0, 1.0); }
  double y(double value) const {
    double height = value / y_most_;
    if (plot_.y_scale == Plot::Scale::logarithmic) {
      height = std::log(std::max(value, plot_.y_least) / plot_.y_least) / std::log(y_most_ / plot_.y_least);
    }
    return bottom() - (bottom() - top()) * std::clamp(height, 0.0, 1.0);
  }
  std::vector<double> y_marks() const {
    if (plot_.y_scale == Plot::Scale::linear) return axis_marks(y_most_, 6);
    std::vector<double> marks;
    for (double mark = plot_.y_least; mark <= y_most_ * 1.001; mark *= 10.0) marks.push_back(mark);
    return marks;
  }

 private:
  const Plot& plot_;
  double x_most_;
  double y_most_;
};

std::string axes(const Plot& plot, const Frame& frame) {
  std::string svg;
  for (const double mark : frame.y_marks()) {
    const double y = frame.y(mark);
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text class=\"mark\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
        frame.left(), frame.right(), y, y, frame.left() - 8.0, y + 4.0, axis_number(mark, plot.y_numbers));
  }
  for (const double mark : axis_marks(frame.x_most(), plot.width / 80)) {
    const double x = frame.x(mark);
    svg += fmt::format(
        "<line class=\"tick\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>"
        "<text class=\"mark\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
        x, x, frame.bottom(), frame.bottom() + 4.0, x, frame.bottom() + 18.0, axis_number(mark, plot.x_numbers));
  }
  svg += fmt::format("<line class=\"axis\" x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>\n", frame.left(),
                     frame.right(), frame.bottom(), frame.bottom());
  svg += fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                     (frame.left() + frame.right()) / 2.0, plot.height - 8, escape_html(plot.x_label));
  const double middle = (frame.top() + frame.bottom()) / 2.0;
  svg += fmt::format(
      "<text class=\"label\" x=\"14\" y=\"{:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 14 "
      "{:.1f})\">{}</text>\n",
      middle, middle, escape_html(plot.y_label));
  return svg;
}

}  // namespace

std::string to_svg(const Plot& plot) {
  const Frame frame(plot);
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n", plot.width, plot.height,
                                escape_html(plot.title));
  svg += axes(plot, frame);
  // The first lines lie above the others.
  for (auto at = plot.lines.rbegin(); at != plot.lines.rend(); ++at) {
    const PlotLine& line = *at;
    svg += fmt::format("<polyline class=\"line line{}\" points=\"", line.style);
    for (const CurvePoint& point : line.points)
      svg += fmt::format("{:.1f},{:.1f} ", frame.x(point.x), frame.y(point.y));
    svg += fmt::format("\"><title>{}</title></polyline>\n", escape_html(line.name));
  }
  return svg + "</svg>\n";
}

std::vector<double> axis_marks(double most, int wanted) {
  if (!(most > 0.0) || !std::isfinite(most)) return {0.0};
  const double raw = most / std::max(wanted, 1);
  double step = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (factor * step >= raw * (1.0 - 1e-9)) {
      step *= factor;
      break;
    }
  }
  std::vector<double> marks;
  for (int i = 0; i * step <= most * (1.0 + 1e-9); ++i) marks.push_back(i * step);
  return marks;
}

std::string axis_number(double value, Plot::Numbers numbers) {
  if (numbers == Plot::Numbers::percent) return fmt::format("{:.4g} %", 100.0 * value);
  if (value >= 1e9) return fmt::format("{:.4g} G", value / 1e9);
  if (value >= 1e6) return fmt::format("{:.4g} M", value / 1e6);
  if (value >= 1e4) return fmt::format("{:.4g} k", value / 1e3);
  return fmt::format("{:.4g}", value);
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace firstlight::app
