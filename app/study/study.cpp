#include "app/study/study.h"

#include <algorithm>

namespace firstlight::app {
namespace {

double share(const SchemeStudy& scheme, const Moment& moment) {
  const std::uint64_t all = scheme.moments.back().traced.traced();
  return all == 0 ? 0.0 : static_cast<double>(moment.traced.traced()) / static_cast<double>(all);
}

/// y of each moment, behind `first` at 0.
template <class Value>
std::vector<CurvePoint> curve(const SchemeStudy& scheme, Over over, double first, const Value& value) {
  std::vector<CurvePoint> points{{0.0, first}};
  for (const Moment& moment : scheme.moments) {
    points.push_back({over == Over::seconds ? moment.seconds : share(scheme, moment), value(moment)});
  }
  return points;
}

}  // namespace

std::vector<CurvePoint> difference_curve(const SchemeStudy& scheme, Over over) {
  return curve(scheme, over, 1.0, [](const Moment& moment) { return moment.difference; });
}

std::vector<CurvePoint> flip_curve(const Study& study, const SchemeStudy& scheme, Over over) {
  return curve(scheme, over, study.black_flip, [](const Moment& moment) { return moment.flip; });
}

std::vector<CurvePoint> queue_curve(const SchemeStudy& scheme) {
  return curve(scheme, Over::seconds, 0.0,
               [](const Moment& moment) { return static_cast<double>(moment.rays_waiting); });
}

std::vector<CurvePoint> rays_curve(const SchemeStudy& scheme, render::RayKind kind) {
  return curve(scheme, Over::seconds, 0.0,
               [&](const Moment& moment) { return static_cast<double>(moment.traced.of(kind)); });
}

std::vector<CurvePoint> share_curve(const SchemeStudy& scheme) {
  return curve(scheme, Over::seconds, 0.0, [&](const Moment& moment) { return share(scheme, moment); });
}

void set_clock(SchemeStudy& scheme) {
  const double watched = scheme.moments.back().seconds;
  const double factor = watched > 0.0 ? median(scheme.seconds) / watched : 1.0;
  for (Moment& moment : scheme.moments) moment.seconds *= factor;
  for (MomentPicture& picture : scheme.pictures) picture.seconds *= factor;
  const std::vector<CurvePoint> shares = share_curve(scheme);
  for (std::optional<Reached>* reached : {&scheme.preview, &scheme.first_image}) {
    if (*reached) (*reached)->share = value_at(shares, (*reached)->seconds);
  }
}

SchemeSummary summarize(const Study& study, const SchemeStudy& scheme) {
  SchemeSummary summary;
  summary.seconds = median(scheme.seconds);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < scheme.seconds.size(); ++round) {
    ratios.push_back(scheme.seconds[round] / study.schemes.front().seconds[round]);
  }
  summary.ratio = median(ratios);
  summary.least_ratio = *std::ranges::min_element(ratios);
  summary.most_ratio = *std::ranges::max_element(ratios);

  const std::vector<CurvePoint> by_share = difference_curve(scheme, Over::share);
  summary.area_by_share = area_under(by_share);
  summary.five_percent = settles_below(by_share, 0.05);
  summary.one_percent = settles_below(by_share, 0.01);
  summary.area_by_seconds = area_under(difference_curve(scheme, Over::seconds));
  summary.flip_area_by_share = area_under(flip_curve(study, scheme, Over::share));
  summary.flip_area_by_seconds = area_under(flip_curve(study, scheme, Over::seconds));
  if (scheme.statistics.worst_case_rays > 0) {
    summary.peak_of_worst_case =
        static_cast<double>(scheme.statistics.peak_rays) / static_cast<double>(scheme.statistics.worst_case_rays);
  }
  return summary;
}

}  // namespace firstlight::app
