#include "app/compare/report/pages.h"

#include "app/compare/record_json.h"
#include "app/compare/record_text.h"
#include "app/compare/report/assets.h"
#include "app/compare/totals.h"
#include "app/study/plot.h"

#include <fmt/format.h>

#include <cmath>

namespace firstlight::app::compare {
namespace {

/// Seen from a scene's page.
std::string picture(const SceneFiles& files, const std::string& kind) { return "../" + files.picture(kind); }

std::string way(const ReportContent& content, const std::vector<SceneFiles>& files, std::size_t index) {
  std::string html = "<nav class=\"way\"><a href=\"../index.html\">&larr; All scenes</a>";
  if (index > 0) {
    html += fmt::format("<a href=\"{}.html\" title=\"{}\">Previous</a>", files[index - 1].stem,
                        escape_html(content.records[index - 1].name));
  }
  if (index + 1 < files.size()) {
    html += fmt::format("<a class=\"next\" href=\"{}.html\" title=\"{}\">Next &rarr;</a>", files[index + 1].stem,
                        escape_html(content.records[index + 1].name));
  }
  return html + "</nav>\n";
}

std::string pictures(const SceneFiles& files) {
  // A small picture is shown larger, as far as its pixels stay pleasant; at most as wide as the page.
  const int room = std::max(files.width, std::min(3 * files.width, 960));
  const Place first = files.worst.empty() ? Place{files.width / 2, files.height / 2, 0, {}, {}} : files.worst.front();
  std::string html =
      "<div class=\"looks\"><div>\n<div class=\"views\">"
      "<button value=\"wipe\" aria-pressed=\"true\">Wipe</button><button value=\"povray\" "
      "aria-pressed=\"false\">POV-Ray</button>"
      "<button value=\"firstlight\" aria-pressed=\"false\">Firstlight</button>"
      "<button value=\"difference\" aria-pressed=\"false\">Difference</button>"
      "<button value=\"flip\" aria-pressed=\"false\">FLIP</button></div>\n";
  html += fmt::format(
      "<div class=\"frame\" data-view=\"wipe\" data-width=\"{0}\" data-height=\"{1}\" data-x=\"{2}\" data-y=\"{3}\" "
      "style=\"--w:{0};--h:{1};--room:{4}px\">\n",
      files.width, files.height, first.x, first.y, room);
  for (const auto& [kind, of, alt] :
       {std::tuple("povray", "first", "POV-Ray's picture"), std::tuple("firstlight", "second", "Firstlight's picture"),
        std::tuple("difference", "map difference", "Their difference, 16 times as strong"),
        std::tuple("flip", "map flip", "The FLIP error")}) {
    html += fmt::format("<img class=\"{}\" src=\"{}\" alt=\"{}\">\n", of, picture(files, kind), alt);
  }
  html +=
      "<span class=\"tag left\">POV-Ray</span><span class=\"tag right\">Firstlight</span><div class=\"spot\"></div>\n"
      "<div class=\"handle\" role=\"slider\" tabindex=\"0\" aria-label=\"Wipe\" aria-valuemin=\"0\" "
      "aria-valuemax=\"100\">"
      "</div></div>\n</div>\n<div class=\"loupes\">\n";
  for (const auto& [kind, caption] :
       {std::pair("povray", "POV-Ray"), std::pair("firstlight", "Firstlight"), std::pair("difference", "difference")}) {
    html += fmt::format(
        "<figure><div class=\"loupe\" tabindex=\"0\" role=\"img\" aria-label=\"{1}, enlarged\" "
        "style=\"background-image:url({0})\"></div><figcaption>{1}</figcaption></figure>\n",
        picture(files, kind), caption);
  }
  return html + "<p class=\"place\"></p></div></div>\n";
}

std::string decibels(double psnr) { return std::isinf(psnr) ? "&infin;" : fmt::format("{:.2f} dB", psnr); }

std::string difference_table(const PictureDifference& found) {
  std::string html = "<div><h2>Pictures</h2>\n<table><tbody>";
  const auto line = [&](const char* label, const std::string& value) {
    html += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", label, value);
  };
  line("within 2/255", fmt::format("{:.3f} %", 100.0 * found.share));
  line("mean error, of 255", fmt::format("{:.4f}", found.mean));
  line("RMS error, of 255", fmt::format("{:.4f}", found.rms));
  line("PSNR", decibels(found.psnr));
  line("PSNR of 8&times;8 means", decibels(found.psnr_8x8));
  line("FLIP, mean", fmt::format("{:.5f}", found.flip));
  line("size", fmt::format("{} &times; {}", found.width, found.height));
  return html + "</tbody></table></div>\n";
}

std::string times_table(const SceneRecord& record) {
  std::string html =
      "<div><h2>Times</h2>\n<table><thead><tr><th></th><th>POV-Ray</th><th>Firstlight</th><th>ratio</th></tr></"
      "thead><tbody>";
  for (const Measure& measure : measures()) {
    const auto middle = [&](const std::vector<ProgramRun>& runs) {
      std::vector<double> values;
      for (const ProgramRun& run : runs) values.push_back(measure.scale * measure.of(run));
      return fmt::format("{:.{}f} {}", spread_of(values).median, measure.unit == "s" ? 3 : 1, measure.unit);
    };
    const std::vector<double> found = ratios(record, measure);
    html +=
        fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", measure.label, middle(record.povray),
                    middle(record.ours), found.empty() ? "&ndash;" : fmt::format("{:.2f}", spread_of(found).median));
  }
  html += "</tbody></table>\n";
  if (record.ours.size() > 1) html += fmt::format("<p class=\"soft\">Medians of {} rounds.</p>\n", record.ours.size());
  return html + "</div>\n";
}

std::string color(const std::array<int, 3>& rgb) {
  return fmt::format("<span class=\"swatch\" style=\"background:rgb({0},{1},{2})\"></span>{0} {1} {2}", rgb[0], rgb[1],
                     rgb[2]);
}

std::string places_table(const std::vector<Place>& places) {
  if (places.empty()) return "<div><h2>Worst pixels</h2>\n<p class=\"soft\">None: the pictures are equal.</p></div>\n";
  std::string html =
      "<div><h2>Worst "
      "pixels</h2>\n<table><thead><tr><th>pixel</th><th>apart</th><th>POV-Ray</th><th>Firstlight</th></tr>"
      "</thead><tbody>";
  for (const Place& place : places) {
    html += fmt::format(
        "<tr><td><button data-x=\"{0}\" data-y=\"{1}\">{0}, "
        "{1}</button></td><td>{2}</td><td>{3}</td><td>{4}</td></tr>\n",
        place.x, place.y, place.difference, color(place.first), color(place.second));
  }
  return html + "</tbody></table></div>\n";
}

std::string missing_list(const SceneRecord& record) {
  std::string html = "<h2>What is missing</h2>\n<ul class=\"missing\">\n";
  for (const MissingFeature& missing : record.missing) {
    html += fmt::format("<li>{} <code>{}:{}:{}</code></li>\n", escape_html(missing.feature), escape_html(missing.file),
                        missing.line, missing.column);
  }
  return html + "</ul>\n";
}

}  // namespace

std::string scene_page(const ReportContent& content, const std::vector<SceneFiles>& files, std::size_t index) {
  const SceneRecord& record = content.records[index];
  const SceneFiles& own = files[index];
  std::string body = way(content, files, index);
  body += fmt::format(
      "<h1>{}</h1>\n<p class=\"verdict {}\"><span class=\"dot\"></span><b>{}</b> &ensp;<code>{}</code></p>\n",
      escape_html(record.name), status_name(record.status), status_text(record.status),
      escape_html(record.scene.string()));
  if (own.has_pictures) body += pictures(own);
  const bool timed = !record.povray.empty() && !record.ours.empty();
  body += "<div class=\"numbers\">\n";
  if (record.difference) body += difference_table(*record.difference);
  if (timed) body += times_table(record);
  if (record.difference) body += places_table(own.worst);
  body += "</div>\n";
  if (!record.missing.empty()) body += missing_list(record);
  if (!record.message.empty()) {
    body += fmt::format("<h2>What was said</h2>\n<pre class=\"said\">{}</pre>\n", escape_html(record.message));
  }
  return html_page(record.name + ": Firstlight beside POV-Ray", body, scene_js());
}

}  // namespace firstlight::app::compare
