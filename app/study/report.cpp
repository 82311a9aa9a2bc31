#include "app/study/report.h"

#include "app/study/report_parts.h"
#include "app/study/thumbnail.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace firstlight::app {
namespace {

constexpr int kStyles = 17;  // of the style sheet: line0 to line16

/// 0 for the first scheme, then 1 to 16, over and over.
int style_of(std::size_t index) {
  return index == 0 ? 0 : 1 + static_cast<int>((index - 1) % static_cast<std::size_t>(kStyles - 1));
}

using CurveOf = std::function<std::vector<CurvePoint>(const SchemeStudy&)>;

Plot plot_of_all(const Study& study, std::string title, std::string x, std::string y, const CurveOf& curve) {
  Plot plot;
  plot.title = std::move(title);
  plot.x_label = std::move(x);
  plot.y_label = std::move(y);
  for (std::size_t i = 0; i < study.schemes.size(); ++i) {
    plot.lines.push_back({study.schemes[i].scheme, style_of(i), curve(study.schemes[i])});
  }
  return plot;
}

std::string difference_figures(const Study& study) {
  const auto difference = [](Over over) {
    return [over](const SchemeStudy& scheme) { return difference_curve(scheme, over); };
  };
  Plot over_time = plot_of_all(study, "Difference over time", "seconds of tracing", "mean absolute difference",
                               difference(Over::seconds));
  over_time.y_numbers = Plot::Numbers::percent;
  over_time.y_most = 1.0;
  Plot over_share = plot_of_all(study, "Difference over rays", "share of the rays", "mean absolute difference",
                                difference(Over::share));
  over_share.x_numbers = over_share.y_numbers = Plot::Numbers::percent;
  over_share.x_most = over_share.y_most = 1.0;
  Plot log_share = over_share;
  log_share.title = "The same, by powers of ten";
  log_share.y_scale = Plot::Scale::logarithmic;
  log_share.y_least = 1e-4;
  return figure(over_time, "The paper's figure 7. A black picture is 100 % away from the finished one.") +
         figure(over_share, "As shares of the rays, so that neither machine nor speed counts.") + figure(log_share, "");
}

std::string flip_figures(const Study& study) {
  const auto flip = [&](Over over) {
    return [&, over](const SchemeStudy& scheme) { return flip_curve(study, scheme, over); };
  };
  Plot over_time = plot_of_all(study, "FLIP over time", "seconds of tracing", "mean FLIP", flip(Over::seconds));
  Plot over_share = plot_of_all(study, "FLIP over rays", "share of the rays", "mean FLIP", flip(Over::share));
  over_share.x_numbers = Plot::Numbers::percent;
  over_share.x_most = 1.0;
  return figure(over_time, fmt::format("How much an eye sees when it flips between the picture and the finished one: a "
                                       "black picture has {:.3f}.",
                                       study.black_flip)) +
         figure(over_share, "");
}

std::string queue_figures(const Study& study) {
  const Plot queue = plot_of_all(study, "Queue length", "seconds of tracing", "rays waiting", queue_curve);
  const std::uint64_t worst = study.schemes.front().statistics.worst_case_rays;
  Plot bound = plot_of_all(study, "What can still change", "share of the rays", "mean over the pixels",
                           [](const SchemeStudy& scheme) {
                             std::vector<CurvePoint> points;
                             const auto all = static_cast<double>(scheme.moments.back().traced.traced());
                             for (const Moment& moment : scheme.moments) {
                               points.push_back({static_cast<double>(moment.traced.traced()) / all, moment.bound});
                             }
                             return points;
                           });
  bound.x_numbers = Plot::Numbers::percent;
  bound.x_most = 1.0;
  return figure(queue, fmt::format("The paper's figure 6. The worst case by its equations 10 to 12 is {} rays.",
                                   axis_number(static_cast<double>(worst), Plot::Numbers::plain))) +
         figure(bound, study.bound_is_proved
                           ? "The engine's own bound, known while it renders: no channel of a pixel, on the mean, can "
                             "change by more (white is 1)."
                           : "The engine's own estimate while it renders; this scene has no bound.");
}

std::string rays_figures(const Study& study) {
  using render::RayKind;
  constexpr std::array<std::pair<RayKind, const char*>, render::kRayKinds> kKinds{
      {{RayKind::primary, "primary"},
       {RayKind::reflection, "reflection"},
       {RayKind::transmission, "transmission"},
       {RayKind::shadow, "shadow"}}};
  double most = 0.0;
  for (const SchemeStudy& scheme : study.schemes) most = std::max(most, scheme.moments.back().seconds);
  std::string html;
  for (const SchemeStudy& scheme : study.schemes) {
    Plot plot;
    plot.title = scheme.scheme;
    plot.x_label = "seconds of tracing";
    plot.y_label = "rays traced";
    plot.width = 400;
    plot.height = 260;
    plot.x_most = most;
    int style = 1;
    for (const auto& [kind, name] : kKinds) {
      if (scheme.moments.back().traced.of(kind) > 0) plot.lines.push_back({name, style, rays_curve(scheme, kind)});
      ++style;
    }
    html += figure(plot, "");
  }
  return html;
}

std::string pictures(const Study& study) {
  std::string html;
  for (const SchemeStudy& scheme : study.schemes) {
    if (scheme.pictures.empty()) continue;
    html += fmt::format("<h3>{}</h3>\n<div class=\"moments\">\n", escape_html(scheme.scheme));
    for (const MomentPicture& picture : scheme.pictures) {
      html += fmt::format(
          "<figure><img alt=\"{:.0f} % of the rays\" src=\"data:image/png;base64,{}\"><figcaption>{:.0f} % of the "
          "rays<br>"
          "{:.3f} s, {:.1f} % off</figcaption></figure>\n",
          100.0 * picture.share, base64(picture.png), 100.0 * picture.share, picture.seconds,
          100.0 * picture.difference);
    }
    html += "</div>\n";
  }
  return html;
}

std::string heading(const Study& study) {
  const render::RayCounts& rays = study.schemes.front().statistics.rays;
  using render::RayKind;
  return fmt::format(
      "<h1>The order of the rays: {}</h1>\n<p class=\"soft\">{} x {} pixels, {} light source{}, {} levels, {} "
      "thread{}. "
      "{} rays: {} primary, {} reflection, {} transmission, {} shadow. {} are traced, the others are feelers whose end "
      "is foreseen.<br><code>{}</code></p>\n",
      escape_html(study.scene), study.width, study.height, study.lights, study.lights == 1 ? "" : "s", study.levels,
      study.threads, study.threads == 1 ? "" : "s", rays.total(), rays.of(RayKind::primary),
      rays.of(RayKind::reflection), rays.of(RayKind::transmission), rays.of(RayKind::shadow), rays.traced(),
      escape_html(study.command));
}

std::string method(const Study& study) {
  return fmt::format(
      "<h2>How it was measured</h2>\n<ul>\n"
      "<li>Times are of tracing alone, the median of {} round{}. Every round renders with all schemes, one after the "
      "other, and begins with another one; a ratio is taken within its round, and its range is in brackets.</li>\n"
      "<li>Curves come from a further round in which all workers rest a hundred times, so that the picture can be "
      "compared. Its clock stands still meanwhile, and is set so that it ends at the median of the undisturbed "
      "rounds.</li>\n"
      "<li>A picture in progress is the one that a viewer is shown: pixels that have no light yet are filled from "
      "their "
      "neighbours.</li>\n"
      "<li>Difference: mean over pixels and channels of |colour - finished colour|, in linear light clipped to [0, 1], "
      "divided by that of a black picture.</li>\n"
      "<li>FLIP: Andersson and others, HPG 2020, at 67 pixels a degree, mean over the pixels.</li>\n"
      "<li>Areas are under the curves from the black picture to the finished one: over the share of the rays from 0 to "
      "1, or over seconds. Less is better: the picture is good sooner. &ldquo;5 % at&rdquo; is the share of the rays "
      "from "
      "which on the difference stays below.</li>\n"
      "<li>The finished pictures of all schemes were compared: they are equal, bit for bit.</li>\n</ul>\n",
      study.schemes.front().seconds.size(), study.schemes.front().seconds.size() == 1 ? "" : "s");
}

}  // namespace

std::string report_html(const Study& study) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Firstlight: {}</title>\n"
      "<style>{}</style></head><body>\n",
      escape_html(study.scene), report_style());
  html += heading(study);
  html += "<h2>Time and queue</h2>\n" + time_table(study);
  html += "<h2>How soon the picture is good</h2>\n" + convergence_table(study);
  html += "<h2>Difference from the finished picture</h2>\n<div class=\"figures\">\n" + difference_figures(study) +
          flip_figures(study) + "</div>\n";
  html += "<h2>What waits</h2>\n<div class=\"figures\">\n" + queue_figures(study) + "</div>\n";
  html +=
      "<h2>Rays by type</h2>\n<p class=\"soft\">The paper's figures 4 and 5: how many rays of each type are traced by "
      "then.</p>\n<div class=\"figures small\">\n" +
      rays_figures(study) + "</div>\n";
  const std::string looks = pictures(study);
  if (!looks.empty()) html += "<h2>What one sees</h2>\n" + looks;
  html += method(study);
  return html + fmt::format("<script>{}</script>\n</body></html>\n", report_script());
}

}  // namespace firstlight::app
