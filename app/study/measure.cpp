#include "app/study/measure.h"

#include "app/study/watch.h"
#include "render/film/film.h"
#include "render/film/preview.h"
#include "render/scene/file_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

namespace firstlight::app {
namespace {

constexpr std::uint64_t kCheckpoints = 100;

bool same_bytes(std::span<const render::Rgb> a, std::span<const render::Rgb> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

class Measurement {
 public:
  Measurement(const StudyPlan& plan, Study& study)
      : plan_(plan),
        study_(study),
        session_(*plan.session),
        view_(session_.view()),
        tracing_(session_.trace_options()) {
    study.width = view_.width;
    study.height = view_.height;
    study.threads = tracing_.threads;
    study.lights = session_.scene().lights.size();
    study.levels = session_.scene().settings.max_trace_level;
  }

  std::string run() {
    for (const StudyPlan::Entry& entry : plan_.schemes) study_.schemes.emplace_back().scheme = entry.text;
    finish_once();
    for (std::size_t i = 0; going_on() && i < plan_.schemes.size(); ++i) watch(i);
    looks_.resize(plan_.schemes.size());
    for (int round = 0; going_on() && round < plan_.rounds; ++round) {
      for (std::size_t i = 0; going_on() && i < plan_.schemes.size(); ++i) {
        time((i + static_cast<std::size_t>(round)) % plan_.schemes.size(), round);
      }
    }
    for (std::size_t i = 0; going_on() && i < plan_.schemes.size(); ++i) finish(i);
    return error_;
  }

 private:
  /// When there was something to see first, in seconds, a number a round.
  struct Looks {
    std::vector<double> preview;
    std::vector<double> first_image;
  };

  bool going_on() const { return error_.empty() && !*tracing_.stop; }
  void say(const std::string& text) const {
    if (plan_.say) plan_.say(text);
  }

  /// Nothing when it was stopped or failed.
  std::optional<priority::TraceStatistics> trace(std::size_t scheme, render::Film& film, priority::Observer* observer,
                                                 std::uint64_t checkpoint_rays) {
    const std::shared_ptr<const priority::Scheme> order = plan_.schemes[scheme].make(film);
    priority::TraceOptions options = tracing_;
    options.scheme = order.get();
    options.observer = observer;
    options.checkpoint_rays = checkpoint_rays;
    const priority::TraceResult result = session_.trace(film, options);
    if (!result.error.empty()) error_ = fmt::format("{}: {}", plan_.schemes[scheme].text, result.error);
    if (!result.complete()) return std::nullopt;
    return result.statistics;
  }

  /// The picture that all others are compared with, and how many rays it takes.
  void finish_once() {
    say(fmt::format("the finished picture, by {}", plan_.schemes[0].text));
    render::Film film(view_.width, view_.height);
    const auto statistics = trace(0, film, nullptr, 0);
    if (!statistics) return;
    rays_ = statistics->rays.traced();
    finished_.emplace(film.snapshot(), view_.width, view_.height, render::file_encoding(session_.scene().settings));
    study_.black_flip = finished_->flip_of_black();
  }

  void watch(std::size_t scheme) {
    say(fmt::format("curves of {}", plan_.schemes[scheme].text));
    render::Film film(view_.width, view_.height);
    Watcher::KeepPicture keep;
    if (plan_.keep_picture) {
      keep = [&](double share, std::span<const render::Rgb> colors) {
        return plan_.keep_picture(scheme, share, colors);
      };
    }
    Watcher watcher(film, *finished_, rays_, std::move(keep));
    const auto statistics = trace(scheme, film, &watcher, std::max<std::uint64_t>(1, rays_ / kCheckpoints));
    if (!statistics) return;
    if (!same_bytes(film.snapshot(), finished_->colors())) {
      error_ =
          fmt::format("the finished pictures of {} and {} differ", plan_.schemes[scheme].text, plan_.schemes[0].text);
      return;
    }
    SchemeStudy& own = study_.schemes[scheme];
    own.moments = watcher.take_moments();
    own.pictures = watcher.take_pictures();
    Moment last;
    last.seconds = statistics->seconds;
    last.traced = statistics->rays;
    own.moments.push_back(last);
    study_.bound_is_proved = study_.bound_is_proved && watcher.bound_is_proved();
  }

  void time(std::size_t scheme, int round) {
    say(fmt::format("round {} of {}: {}", round + 1, plan_.rounds, plan_.schemes[scheme].text));
    render::Film film(view_.width, view_.height);
    const auto begin = std::chrono::steady_clock::now();
    const auto statistics = trace(scheme, film, nullptr, 0);
    if (!statistics) return;
    const auto since = [&](const std::optional<std::chrono::steady_clock::time_point>& point) {
      return std::chrono::duration<double>(*point - begin).count();
    };
    SchemeStudy& own = study_.schemes[scheme];
    own.seconds.push_back(statistics->seconds);
    own.statistics = *statistics;
    if (statistics->preview) looks_[scheme].preview.push_back(since(statistics->preview));
    if (statistics->first_image) looks_[scheme].first_image.push_back(since(statistics->first_image));
  }

  void finish(std::size_t scheme) {
    SchemeStudy& own = study_.schemes[scheme];
    const Looks& looks = looks_[scheme];
    if (!looks.preview.empty()) own.preview = Reached{median(looks.preview), 0.0};
    if (!looks.first_image.empty()) own.first_image = Reached{median(looks.first_image), 0.0};
    set_clock(own);
  }

  const StudyPlan& plan_;
  Study& study_;
  const Session& session_;
  const render::View view_;
  const priority::TraceOptions tracing_;
  std::string error_;
  std::uint64_t rays_ = 0;
  std::optional<FinishedPicture> finished_;
  std::vector<Looks> looks_;
};

}  // namespace

std::string measure(const StudyPlan& plan, Study& study) { return Measurement(plan, study).run(); }

}  // namespace firstlight::app
