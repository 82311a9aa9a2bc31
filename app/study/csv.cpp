#include "app/study/csv.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

namespace firstlight::app {
namespace {

using Rows = std::function<void(std::string& text, const SchemeStudy& scheme, const std::string& name)>;

CsvFile file(const Study& study, std::string name, std::string heading, const Rows& rows) {
  CsvFile csv{std::move(name), std::move(heading) + "\n"};
  for (const SchemeStudy& scheme : study.schemes) rows(csv.text, scheme, csv_field(scheme.scheme));
  return csv;
}

std::string optional_number(const std::optional<double>& number) {
  return number ? fmt::format("{:.5f}", *number) : std::string();
}

void add_summary(std::string& text, const Study& study, const SchemeStudy& scheme, const std::string& name) {
  const SchemeSummary summary = summarize(study, scheme);
  const auto seconds = [](const std::optional<Reached>& reached) {
    return reached ? std::optional(reached->seconds) : std::nullopt;
  };
  text += fmt::format("{},{:.5f},{:.4f},{:.4f},{:.4f},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{},{},{},{},{},{:.6f}\n", name,
                      summary.seconds, summary.ratio, summary.least_ratio, summary.most_ratio,
                      optional_number(seconds(scheme.preview)), optional_number(seconds(scheme.first_image)),
                      summary.area_by_share, summary.area_by_seconds, summary.flip_area_by_share,
                      summary.flip_area_by_seconds, optional_number(summary.five_percent),
                      optional_number(summary.one_percent), scheme.statistics.peak_rays, scheme.statistics.peak_bytes,
                      scheme.statistics.worst_case_rays, summary.peak_of_worst_case);
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::vector<CsvFile> csv_files(const Study& study) {
  using render::RayKind;
  std::vector<CsvFile> files;
  files.push_back(
      file(study, "summary.csv",
           "scheme,seconds,ratio,least_ratio,most_ratio,preview_s,first_image_s,area_by_share,area_by_seconds,"
           "flip_area_by_share,flip_area_by_seconds,share_at_5_percent,share_at_1_percent,peak_rays,"
           "peak_bytes,worst_case_rays,peak_of_worst_case",
           [&](std::string& text, const SchemeStudy& scheme, const std::string& name) {
             add_summary(text, study, scheme, name);
           }));
  files.push_back(file(study, "rounds.csv", "scheme,round,seconds",
                       [](std::string& text, const SchemeStudy& scheme, const std::string& name) {
                         for (std::size_t i = 0; i < scheme.seconds.size(); ++i) {
                           text += fmt::format("{},{},{:.5f}\n", name, i + 1, scheme.seconds[i]);
                         }
                       }));
  files.push_back(file(study, "rays_by_type.csv", "scheme,seconds,primary,reflection,transmission,shadow",
                       [](std::string& text, const SchemeStudy& scheme, const std::string& name) {
                         for (const Moment& moment : scheme.moments) {
                           text +=
                               fmt::format("{},{:.5f},{},{},{},{}\n", name, moment.seconds,
                                           moment.traced.of(RayKind::primary), moment.traced.of(RayKind::reflection),
                                           moment.traced.of(RayKind::transmission), moment.traced.of(RayKind::shadow));
                         }
                       }));
  files.push_back(file(study, "queue.csv", "scheme,seconds,rays_waiting,bytes",
                       [](std::string& text, const SchemeStudy& scheme, const std::string& name) {
                         for (const Moment& moment : scheme.moments) {
                           text += fmt::format("{},{:.5f},{},{}\n", name, moment.seconds, moment.rays_waiting,
                                               moment.queue_bytes);
                         }
                       }));
  const auto curve_file = [&](const std::string& name, const std::string& value, const auto& number) {
    files.push_back(file(study, name, "scheme,seconds,share_of_rays," + value,
                         [&](std::string& text, const SchemeStudy& scheme, const std::string& quoted) {
                           const auto all = static_cast<double>(scheme.moments.back().traced.traced());
                           for (const Moment& moment : scheme.moments) {
                             text += fmt::format("{},{:.5f},{:.5f},{:.6f}\n", quoted, moment.seconds,
                                                 static_cast<double>(moment.traced.traced()) / all, number(moment));
                           }
                         }));
  };
  curve_file("difference.csv", "difference", [](const Moment& moment) { return moment.difference; });
  curve_file("flip.csv", "flip", [](const Moment& moment) { return moment.flip; });
  curve_file("bound.csv", "bound", [](const Moment& moment) { return moment.bound; });
  return files;
}

}  // namespace firstlight::app
