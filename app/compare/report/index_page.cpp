#include "app/compare/report/pages.h"

#include "app/compare/record_json.h"
#include "app/compare/report/assets.h"
#include "app/compare/totals.h"
#include "app/pov_switches.h"
#include "app/study/plot.h"
#include "app/study/report_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>

namespace firstlight::app::compare {
namespace {

/// The worst first: where something is wrong, what agrees, what could not be compared.
constexpr std::array<Status, kStatuses> kWorstFirst{Status::ours_failed,   Status::other_size, Status::differs,
                                                    Status::warns,         Status::agrees,     Status::lacks_features,
                                                    Status::povray_failed, Status::both_failed};

std::string fact(const std::string& number, const std::string& what) {
  return fmt::format("<div><b>{}</b><span>{}</span></div>\n", number, what);
}

std::string of_all(std::size_t count, std::size_t all) { return fmt::format("{} <small>of {}</small>", count, all); }

std::string times(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.2f}<small>&times;</small>", *ratio) : std::string("&ndash;");
}

std::string facts(const Totals& sum) {
  std::string html = "<div class=\"facts\">\n" + fact(of_all(sum.of(Status::agrees), sum.scenes), "scenes agree");
  if (sum.timed > 0) {
    html += fact(times(sum.trace_ratio), "as fast as POV-Ray: tracing, geometric mean");
    html += fact(times(sum.whole_ratio), "as fast as POV-Ray: the whole process");
    html += fact(of_all(sum.slower_whole, sum.timed), "slower than POV-Ray, the whole process");
  }
  if (sum.of(Status::lacks_features) > 0) {
    html += fact(fmt::format("{}", sum.of(Status::lacks_features)), "lack features");
  }
  return html + "</div>\n";
}

std::string bar(const Totals& sum) {
  std::string html = "<div class=\"bar\" aria-hidden=\"true\">";
  for (const Status status : kWorstFirst) {
    if (sum.of(status) > 0) {
      html += fmt::format("<i class=\"{}\" style=\"flex:{}\" title=\"{}: {}\"></i>", status_name(status),
                          sum.of(status), status_text(status), sum.of(status));
    }
  }
  return html + "</div>\n";
}

std::string tools(const Totals& sum) {
  std::string html =
      "<div class=\"tools\"><input type=\"search\" aria-label=\"Filter\" placeholder=\"Scene or feature\">"
      "<div class=\"chips\">\n";
  for (const Status status : kWorstFirst) {
    if (sum.of(status) > 0) {
      html += fmt::format(
          "<button class=\"chip {0}\" value=\"{0}\" aria-pressed=\"true\"><span class=\"dot\"></span>{1} "
          "{2}</button>\n",
          status_name(status), status_text(status), sum.of(status));
    }
  }
  return html + "</div><output></output></div>\n";
}

/// A number of a row: how it is sorted by, and how it is said. Nothing where there is none.
struct Cell {
  std::string key;
  std::string label;
  bool worst_is_least = true;
  std::optional<double> value = {};
  std::string text = {};
  bool is_slow = false;
};

std::vector<Cell> cells(const SceneRecord& record) {
  std::vector<Cell> cells(6);
  cells[0] = {"share", "within 2/255"};
  cells[1] = {"psnr", "PSNR"};
  cells[2] = {"flip", "FLIP", false};
  cells[3] = {"worst", "worst", false};
  cells[4] = {"trace", "tracing"};
  cells[5] = {"whole", "process"};
  if (record.difference) {
    const PictureDifference& found = *record.difference;
    const auto set = [&](std::size_t i, double value, std::string text) {
      cells[i].value = value;
      cells[i].text = std::move(text);
    };
    set(0, found.share, fmt::format("{:.2f} %", 100.0 * found.share));
    set(1, std::min(found.psnr, 999.0), std::isinf(found.psnr) ? "&infin;" : fmt::format("{:.1f} dB", found.psnr));
    set(2, found.flip, fmt::format("{:.4f}", found.flip));
    set(3, found.worst, fmt::format("{}", found.worst));
  }
  const auto set_ratio = [&](Cell& cell, const std::optional<double>& ratio) {
    cell.value = ratio;
    if (ratio) cell.text = fmt::format("{:.2f}&times;", *ratio);
    cell.is_slow = ratio && *ratio < 1.0;
  };
  set_ratio(cells[4], trace_ratio(record));
  set_ratio(cells[5], whole_ratio(record));
  return cells;
}

std::string missing_names(const SceneRecord& record) {
  std::string names;
  for (const MissingFeature& missing : record.missing) names += (names.empty() ? "" : ", ") + missing.feature;
  return names;
}

std::string row(const SceneRecord& record, const SceneFiles& files, int rank) {
  const std::string why = record.missing.empty() ? record.message : "lacks " + missing_names(record);
  std::string html = fmt::format(
      "<tr class=\"{0}\" data-status=\"{0}\" data-badness=\"{1}\" data-name=\"{2}\" data-text=\"{3}\"",
      status_name(record.status), rank, escape_html(record.name), escape_html(lower(record.name + " " + why)));
  const std::vector<Cell> numbers = cells(record);
  for (const Cell& cell : numbers) {
    if (cell.value) html += fmt::format(" data-{}=\"{}\"", cell.key, *cell.value);
  }
  html += ">\n<td>";
  if (files.has_pictures) {
    html += fmt::format("<a class=\"trio\" href=\"{}\" tabindex=\"-1\" aria-hidden=\"true\">", files.page());
    for (const char* kind : {"povray", "firstlight", "difference"}) {
      html += fmt::format("<img src=\"{}\" alt=\"\" loading=\"lazy\">", files.picture(kind + std::string("-small")));
    }
    html += "</a>";
  }
  html += fmt::format("</td><td class=\"name\"><a href=\"{}\">{}</a>", files.page(), escape_html(record.name));
  if (!why.empty()) html += fmt::format("<span class=\"why\">{}</span>", escape_html(why));
  html += fmt::format("</td><td><span class=\"dot\"></span>{}</td>", status_text(record.status));
  for (const Cell& cell : numbers) {
    html += cell.value ? fmt::format("<td data-label=\"{}\"{}>{}</td>", cell.label,
                                     cell.is_slow ? " class=\"slow\"" : "", cell.text)
                       : std::string("<td class=\"none\">&ndash;</td>");
  }
  return html + "</tr>\n";
}

std::string scenes_table(const ReportContent& content, const std::vector<SceneFiles>& files) {
  std::vector<std::size_t> order(content.records.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto share = [&](std::size_t i) {
    const auto& difference = content.records[i].difference;
    return difference ? difference->share : 1.0;
  };
  const auto lacks = [&](std::size_t i) { return content.records[i].missing.size(); };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const int left = badness(content.records[a]);
    const int right = badness(content.records[b]);
    if (left != right) return left < right;
    return share(a) != share(b) ? share(a) < share(b) : lacks(a) > lacks(b);
  });
  std::string html =
      "<table class=\"scenes\"><thead><tr><th>POV-Ray, Firstlight, difference</th>"
      "<th data-sort=\"name\"><button>scene</button></th>"
      "<th data-sort=\"badness\"><button>status</button></th>";
  for (const Cell& cell : cells(SceneRecord())) {
    html += fmt::format("<th data-sort=\"{}\" data-first=\"{}\"><button>{}</button></th>", cell.key,
                        cell.worst_is_least ? "ascending" : "descending", cell.label);
  }
  html += "</tr></thead><tbody>\n";
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    html += row(content.records[order[rank]], files[order[rank]], static_cast<int>(rank));
  }
  return html + "</tbody></table>\n<p class=\"empty\" hidden>No scene is like that.</p>\n";
}

std::string features_table(const Totals& sum) {
  if (sum.missing.empty()) return {};
  std::string html =
      "<h2>What is missing</h2>\n<div class=\"scroll\"><table "
      "class=\"features\"><thead><tr><th>feature</th><th>scenes</th>"
      "<th>that lack nothing else</th></tr></thead><tbody>\n";
  for (const FeatureCount& count : sum.missing) {
    html += fmt::format("<tr><td><button data-feature=\"{0}\">{0}</button></td><td>{1}</td><td>{2}</td></tr>\n",
                        escape_html(count.feature), count.scenes, count.alone);
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

int badness(const SceneRecord& record) {
  return static_cast<int>(std::ranges::find(kWorstFirst, record.status) - kWorstFirst.begin());
}

std::string file_stem(std::size_t number, const std::string& name) {
  constexpr std::size_t kLongest = 60;
  std::string stem;
  for (const char c : name.substr(0, kLongest)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80) {
      stem += c;
    } else if (!stem.ends_with('-')) {
      stem += '-';
    }
  }
  while (stem.ends_with('-')) stem.pop_back();
  return fmt::format("{:04}-{}", number, stem);
}

std::string html_page(std::string_view title, std::string_view body, std::string_view script) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n{}\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>{}{}</style></head><body>\n{}<script>{}</script>\n</body></html>\n",
      kReportMark, escape_html(title), report_style(), report_css(), body, script);
}

std::string index_page(const ReportContent& content, const std::vector<SceneFiles>& files) {
  const Totals sum = totals(content.records);
  std::string body = fmt::format("<h1>{} beside POV-Ray</h1>\n<p class=\"command\"><code>{}</code></p>\n",
                                 escape_html(content.title), escape_html(content.command));
  body += facts(sum) + bar(sum) + "<h2>Scenes</h2>\n" + tools(sum) + scenes_table(content, files) + features_table(sum);
  body +=
      "<h2>How to read it</h2>\n<ul>\n<li>A pixel agrees when none of its channels is more than 2 of 255 away from "
      "POV-Ray's.</li>\n<li>A difference is shown 16 times as strong.</li>\n<li>FLIP tells how much an eye sees when "
      "it "
      "flips between the pictures, from 0 to 1.</li>\n<li>Tracing and process: POV-Ray's time over Firstlight's, so "
      "more "
      "than 1 is faster.</li>\n</ul>\n";
  return html_page(content.title + " beside POV-Ray", body, index_js());
}

}  // namespace firstlight::app::compare
