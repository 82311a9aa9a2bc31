// How fast pictures converge in each order: renders a scene to its end, then once with each scheme, looking at the
// picture after each per cent of the rays that are traced.
//
//   convergence SCENE WIDTH HEIGHT SCHEME [SCHEME ...] [--every-feeler] [--curve]
//
// Prints the area under the curve of the difference from the finished picture (1: black) over the rays traced, and
// after how many the difference stays below 5 % and 1 %. Rays are counted as shares of all rays of the picture, of
// which feelers with an end that is foreseen need not be traced, and as shares of those that are traced. The same over
// seconds of tracing, whose area is in seconds. With --every-feeler no end is foreseen. --curve prints the curves over
// the rays that are traced, too.
#include "app/study/curve.h"
#include "parser/function_text.h"
#include "parser/parser.h"
#include "priority/driver.h"
#include "priority/order.h"
#include "render/accel/accel.h"
#include "render/film/preview.h"
#include "render/image/difference.h"
#include "render/scene/scene_index.h"
#include "render/trace/medium_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace firstlight;

constexpr int kCheckpoints = 100;

/// Looks at the picture at each checkpoint.
struct Watcher final : priority::Observer {
  Watcher(const render::Film& watched, const render::RemainingDifference& difference_of, double all_rays)
      : film(watched), difference(difference_of), rays(all_rays) {}

  void checkpoint(const priority::Progress& progress) override {
    const std::vector<render::Rgb> picture = render::preview(film);
    const double left = difference(picture);
    curve.push_back({static_cast<double>(progress.traced.traced()) / rays, left});
    in_time.push_back({progress.seconds, left});
    traced.push_back(progress.traced);
  }

  const render::Film& film;
  const render::RemainingDifference& difference;
  double rays;
  std::vector<app::CurvePoint> curve{{0.0, 1.0}};    ///< over the share of rays
  std::vector<app::CurvePoint> in_time{{0.0, 1.0}};  ///< over seconds of tracing
  std::vector<render::RayCounts> traced{{}};         ///< at the points of the curve
};

[[noreturn]] void fail(const std::string& why) {
  fmt::print(stderr, "convergence: {}\n", why);
  std::exit(EXIT_FAILURE);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool wants_curve = std::erase(arguments, "--curve") > 0;
  const bool every_feeler = std::erase(arguments, "--every-feeler") > 0;
  if (arguments.size() < 4) {
    fail("usage: convergence SCENE WIDTH HEIGHT SCHEME [SCHEME ...] [--every-feeler] [--curve]");
  }
  render::LoadOptions load;
  load.width = std::atoi(arguments[1].c_str());
  load.height = std::atoi(arguments[2].c_str());
  if (load.width < 1 || load.height < 1) fail("width and height are numbers of pixels");
  const render::LoadResult loaded = parser::PovFrontEnd().load(arguments[0], load);
  if (loaded.scene == nullptr) fail("cannot read the scene " + arguments[0]);
  const render::Accel accel(*loaded.scene, every_feeler ? render::Foresight::none : render::Foresight::some);
  priority::SchemeInput input;
  input.scene = render::index_of(*loaded.scene);
  input.width = load.width;
  input.height = load.height;
  input.compile = parser::compile_text;

  std::vector<render::Rgb> finished;
  double rays = 0.0;
  const auto render = [&](const std::string& text, const auto& watch) {
    render::MediumTable media;
    render::Film film(load.width, load.height);
    input.film = &film;
    std::string error;
    const auto order = priority::Order::parse(text, input, error);
    if (!order) fail(error);
    const std::shared_ptr<const priority::Scheme> scheme = order->scheme();
    priority::TraceOptions options;
    options.scheme = scheme.get();
    watch(film, options);
    const priority::TraceResult result = priority::trace({*loaded.scene, accel, media}, film, options);
    if (!result.complete()) fail("rendering ended early: " + result.error);
    finished = film.snapshot();
    rays = static_cast<double>(result.statistics.rays.traced());
    return result.statistics;
  };
  const render::RayCounts counts = render("contribution", [](const render::Film&, priority::TraceOptions&) {}).rays;
  fmt::print("{} of {} rays are traced; the others are feelers whose end is foreseen\n", counts.traced(),
             counts.total());
  const double share_traced = static_cast<double>(counts.traced()) / static_cast<double>(counts.total());
  const std::vector<render::Rgb> reference = finished;
  const render::RemainingDifference difference(reference);
  const double all_rays = rays;

  fmt::print("{:<40} {:>8} {:>6} {:>6} {:>8} {:>6} {:>6} {:>12} {:>8} {:>8} {:>8} {:>8}\n", "scheme", "of all", "5 %",
             "1 %", "traced", "5 %", "1 %", "peak rays", "seconds", "area, s", "5 %, s", "1 %, s");
  for (std::size_t i = 3; i < arguments.size(); ++i) {
    std::unique_ptr<Watcher> watcher;
    const auto statistics = render(arguments[i], [&](const render::Film& film, priority::TraceOptions& options) {
      watcher = std::make_unique<Watcher>(film, difference, all_rays);
      options.observer = watcher.get();
      options.checkpoint_rays = static_cast<std::uint64_t>(all_rays / kCheckpoints);
    });
    watcher->curve.push_back({1.0, 0.0});
    watcher->traced.push_back(statistics.rays);
    watcher->in_time.push_back({statistics.seconds, 0.0});
    const double area = app::area_under(watcher->curve);
    const double five = app::settles_below(watcher->curve, 0.05).value_or(1.0);
    const double one = app::settles_below(watcher->curve, 0.01).value_or(1.0);
    fmt::print(
        "{:<40} {:>8.4f} {:>6.3f} {:>6.3f} {:>8.4f} {:>6.3f} {:>6.3f} {:>12} {:>8.2f} {:>8.4f} {:>8.3f} {:>8.3f}\n",
        arguments[i], area * share_traced, five * share_traced, one * share_traced, area, five, one,
        statistics.peak_rays, statistics.seconds, app::area_under(watcher->in_time),
        app::settles_below(watcher->in_time, 0.05).value_or(0.0),
        app::settles_below(watcher->in_time, 0.01).value_or(0.0));
    if (!wants_curve) continue;
    fmt::print("  share of rays, difference, share of primary, reflected, transmitted rays and of feelers\n");
    for (std::size_t p = 0; p < watcher->curve.size(); ++p) {
      fmt::print("  {:.4f} {:.5f}", watcher->curve[p].x, watcher->curve[p].y);
      for (std::size_t kind = 0; kind < 4; ++kind) {
        const auto all = static_cast<double>(std::max<std::uint64_t>(statistics.rays.by_kind[kind], 1));
        fmt::print(" {:.4f}", static_cast<double>(watcher->traced[p].by_kind[kind]) / all);
      }
      fmt::print("\n");
    }
  }
  return EXIT_SUCCESS;
}
