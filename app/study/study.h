#pragma once

#include "app/study/curve.h"
#include "priority/driver.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::app {

/// Where a picture stands at one moment of its making.
struct Moment {
  double seconds = 0.0;  ///< of tracing; so that the last moment's are the median of SchemeStudy::seconds
  render::RayCounts traced;
  std::uint64_t rays_waiting = 0;
  std::size_t queue_bytes = 0;
  double difference = 0.0;  ///< render::RemainingDifference
  double flip = 0.0;        ///< mean render::Flip
  double bound = 0.0;       ///< priority::Progress::remaining
};

/// The picture at a moment, as a small PNG.
struct MomentPicture {
  double share = 0.0;  ///< of the rays that are traced
  double seconds = 0.0;
  double difference = 0.0;
  std::string png;
};

/// When something was reached first.
struct Reached {
  double seconds = 0.0;
  double share = 0.0;  ///< of the rays that are traced
};

/// One way to order the rays, measured.
struct SchemeStudy {
  std::string scheme;
  std::vector<double> seconds;  ///< of tracing, undisturbed, a number a round
  std::optional<Reached> preview;
  std::optional<Reached> first_image;
  priority::TraceStatistics statistics;  ///< of an undisturbed round
  /// From a round of its own that rests to be looked at; the last one is the finished picture.
  std::vector<Moment> moments;
  std::vector<MomentPicture> pictures;
};

/// All that a report says about a scene.
struct Study {
  std::string scene;
  std::string command;
  int width = 0;
  int height = 0;
  int threads = 0;
  std::size_t lights = 0;
  int levels = 0;
  double black_flip = 0.0;           ///< mean render::Flip of a black picture
  bool bound_is_proved = true;       ///< else Moment::bound is an estimate
  std::vector<SchemeStudy> schemes;  ///< the first is what all times are compared with
};

// ---- Curves of a scheme, from the black picture at 0 to the finished one
enum class Over { seconds, share };
std::vector<CurvePoint> difference_curve(const SchemeStudy& scheme, Over over);
std::vector<CurvePoint> flip_curve(const Study& study, const SchemeStudy& scheme, Over over);
std::vector<CurvePoint> queue_curve(const SchemeStudy& scheme);
std::vector<CurvePoint> rays_curve(const SchemeStudy& scheme, render::RayKind kind);
/// Share of the rays over seconds.
std::vector<CurvePoint> share_curve(const SchemeStudy& scheme);

/// Makes the clock of the moments and pictures, which has run while they were looked at, that of the undisturbed
/// rounds: it ends at their median. Then tells of what was reached the share of the rays. Pre: at least one round and
/// moment.
void set_clock(SchemeStudy& scheme);

/// The numbers of a scheme that a table shows.
struct SchemeSummary {
  double seconds = 0.0;  ///< median
  double ratio = 1.0;    ///< to the first scheme's time: median over rounds of the ratio within the round
  double least_ratio = 1.0;
  double most_ratio = 1.0;
  double area_by_share = 0.0;    ///< under the difference, 0 to 1
  double area_by_seconds = 0.0;  ///< in seconds of a black picture
  double flip_area_by_share = 0.0;
  double flip_area_by_seconds = 0.0;
  std::optional<double> five_percent;  ///< share of the rays from which on the difference is at most so much
  std::optional<double> one_percent;
  double peak_of_worst_case = 0.0;  ///< longest queue as a share of the worst case
};
/// Pre: the study has that scheme, and each scheme at least one round and one moment, as many rounds as the first.
SchemeSummary summarize(const Study& study, const SchemeStudy& scheme);

}  // namespace firstlight::app
