#include "app/study/report_parts.h"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <vector>

namespace firstlight::app {
namespace {

/// A column of numbers, of which the least or the most is the best.
struct Column {
  std::string heading;
  std::function<std::optional<double>(const SchemeStudy&, const SchemeSummary&)> value;
  std::function<std::string(double)> text;
  bool mark_least = true;
  /// Gives the text that follows the number; may be empty.
  std::function<std::string(const SchemeStudy&, const SchemeSummary&)> more = {};
};

std::function<std::string(double)> digits(int count) {
  return [count](double value) { return fmt::format("{:.{}f}", value, count); };
}

std::string percent(double value) { return fmt::format("{:.1f} %", 100.0 * value); }

std::string table(const Study& study, const std::vector<Column>& columns) {
  std::vector<SchemeSummary> summaries;
  for (const SchemeStudy& scheme : study.schemes) summaries.push_back(summarize(study, scheme));
  std::string html = "<div class=\"scroll\"><table><thead><tr><th>scheme</th>";
  std::vector<double> best;
  for (const Column& column : columns) {
    html += fmt::format("<th>{}</th>", escape_html(column.heading));
    best.push_back(std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < summaries.size(); ++i) {
      const auto value = column.value(study.schemes[i], summaries[i]);
      if (column.mark_least && value && *value < best.back()) best.back() = *value;
    }
  }
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    html += fmt::format("<tr><td>{}</td>", escape_html(study.schemes[i].scheme));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const auto value = columns[c].value(study.schemes[i], summaries[i]);
      const bool is_best = value && *value == best[c];
      html += fmt::format("<td{}>{}{}</td>", is_best ? " class=\"best\"" : "",
                          value ? columns[c].text(*value) : std::string("&ndash;"),
                          columns[c].more ? columns[c].more(study.schemes[i], summaries[i]) : std::string());
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::optional<double> seconds_of(const std::optional<Reached>& reached) {
  return reached ? std::optional(reached->seconds) : std::nullopt;
}

std::string share_of(const std::optional<Reached>& reached) {
  return reached ? fmt::format(" <span class=\"soft\">({})</span>", percent(reached->share)) : std::string();
}

}  // namespace

std::string time_table(const Study& study) {
  using Scheme = const SchemeStudy&;
  using Summary = const SchemeSummary&;
  const std::string base = study.schemes.front().scheme;
  return table(
      study,
      {{"tracing, s", [](Scheme, Summary s) { return std::optional(s.seconds); }, digits(3)},
       {"time / " + base, [](Scheme, Summary s) { return std::optional(s.ratio); }, digits(2), true,
        [](Scheme, Summary s) {
          return fmt::format(" <span class=\"soft\">({:.2f} to {:.2f})</span>", s.least_ratio, s.most_ratio);
        }},
       {"first preview, s (rays)", [](Scheme scheme, Summary) { return seconds_of(scheme.preview); }, digits(4), true,
        [](Scheme scheme, Summary) { return share_of(scheme.preview); }},
       {"first image, s (rays)", [](Scheme scheme, Summary) { return seconds_of(scheme.first_image); }, digits(4), true,
        [](Scheme scheme, Summary) { return share_of(scheme.first_image); }},
       {"longest queue, rays",
        [](Scheme scheme, Summary) { return std::optional(static_cast<double>(scheme.statistics.peak_rays)); },
        digits(0), false},
       {"of the worst case", [](Scheme, Summary s) { return std::optional(s.peak_of_worst_case); },
        [](double value) { return fmt::format("{:.2f} %", 100.0 * value); }, false},
       {"memory of the queue, MB",
        [](Scheme scheme, Summary) { return std::optional(static_cast<double>(scheme.statistics.peak_bytes) / 1e6); },
        digits(1), false}});
}

std::string convergence_table(const Study& study) {
  using Scheme = const SchemeStudy&;
  using Summary = const SchemeSummary&;
  return table(
      study,
      {{"difference: area by share", [](Scheme, Summary s) { return std::optional(s.area_by_share); }, digits(4)},
       {"5 % at", [](Scheme, Summary s) { return s.five_percent; }, percent},
       {"1 % at", [](Scheme, Summary s) { return s.one_percent; }, percent},
       {"area by time, s", [](Scheme, Summary s) { return std::optional(s.area_by_seconds); }, digits(4)},
       {"FLIP: area by share", [](Scheme, Summary s) { return std::optional(s.flip_area_by_share); }, digits(4)},
       {"area by time, s", [](Scheme, Summary s) { return std::optional(s.flip_area_by_seconds); }, digits(4)}});
}

std::string figure(const Plot& plot, const std::string& caption) {
  std::string html = fmt::format("<figure>\n<h3>{}</h3>\n<ul class=\"legend\">", escape_html(plot.title));
  for (const PlotLine& line : plot.lines) {
    html += fmt::format(
        "<li data-line=\"line{}\"><svg viewBox=\"0 0 26 8\" aria-hidden=\"true\"><polyline class=\"line line{}\" "
        "points=\"0,4 26,4\"/></svg>{}</li>",
        line.style, line.style, escape_html(line.name));
  }
  html += "</ul>\n" + to_svg(plot);
  if (!caption.empty()) html += "<figcaption>" + caption + "</figcaption>\n";
  return html + "</figure>\n";
}

}  // namespace firstlight::app
