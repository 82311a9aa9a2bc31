#include "app/compare/agreement.h"

#include "app/compare/totals.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <vector>

namespace firstlight::app::compare {
namespace {

/// Escapes what would be read as Markdown, so that it stands for itself.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      out += ' ';
      continue;
    }
    if (std::string_view("\\`*_{}[]<>|#").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

struct Place {
  std::string folder;
  std::string name;
};

Place place_of(const SceneRecord& record) {
  const std::size_t slash = record.name.substr(0, record.name.find(' ')).rfind('/');
  if (slash == std::string::npos) return {"", record.name};
  return {record.name.substr(0, slash), record.name.substr(slash + 1)};
}

std::string ratio_text(const std::optional<double>& ratio) { return ratio ? fmt::format("{:.2f}", *ratio) : "-"; }

std::size_t lacks(const SceneRecord& record) {
  std::set<std::string_view> features;
  for (const MissingFeature& missing : record.missing) features.insert(missing.feature);
  return features.size();
}

std::string row_of(const SceneRecord& record, const std::string& name) {
  return fmt::format("| {} | {} | {} | {} | {} |\n", plain(name), status_text(record.status),
                     record.difference ? fmt::format("{:.2f} %", 100.0 * record.difference->share)
                                       : plain(record.message.substr(0, 80)),
                     ratio_text(trace_ratio(record)), ratio_text(whole_ratio(record)));
}

std::string head(const Totals& sum) {
  std::string text = "| | scenes |\n|---|---|\n";
  for (std::size_t i = 0; i < kStatuses; ++i) {
    if (sum.by_status[i] > 0)
      text += fmt::format("| {} | {} |\n", status_text(static_cast<Status>(i), sum.by_status[i]), sum.by_status[i]);
  }
  text += fmt::format("| all | {} |\n\n", sum.scenes);
  if (sum.timed > 0) {
    text += fmt::format(
        "Of the {} that both programs rendered, POV-Ray's time over Firstlight's, geometric means: tracing {}, the "
        "whole "
        "process {}.\nSlower than POV-Ray: tracing in {}, the whole process in {}.\n\n",
        sum.timed, ratio_text(sum.trace_ratio), ratio_text(sum.whole_ratio), sum.slower_trace, sum.slower_whole);
  }
  return text;
}

std::string missing_table(const Totals& sum) {
  if (sum.missing.empty()) return {};
  std::string text = "## Missing\n\n| feature | scenes | that lack nothing else |\n|---|---|---|\n";
  for (const FeatureCount& count : sum.missing) {
    text += fmt::format("| {} | {} | {} |\n", plain(count.feature), count.scenes, count.alone);
  }
  return text + "\n";
}

}  // namespace

std::string agreement_page(std::span<const SceneRecord> records, std::string_view command) {
  const Totals sum = totals(records);
  std::string text = fmt::format(
      "# Agreement with POV-Ray\n\nMade by\n\n    {}\n\n"
      "Status; the share of pixels that are within 2/255 of POV-Ray's; and how many times as fast as POV-Ray the rays "
      "are "
      "traced and\nthe whole process is. A scene that lacks features is only read; the "
      "number behind it says how many\nfeatures it lacks.\n\n",
      command);
  text += head(sum) + missing_table(sum) + "## Scenes\n";
  std::map<std::string, std::vector<const SceneRecord*>> folders;
  for (const SceneRecord& record : records) folders[place_of(record).folder].push_back(&record);
  for (const auto& [folder, scenes] : folders) {
    text += fmt::format("\n### {}\n\n", folder.empty() ? "(top)" : plain(folder));
    std::string rows;
    std::string others;
    for (const SceneRecord* record : scenes) {
      const std::string name = place_of(*record).name;
      if (record->status == Status::lacks_features) {
        others += fmt::format("{}{} {}", others.empty() ? "" : ", ", plain(name), lacks(*record));
      } else {
        rows += row_of(*record, name);
      }
    }
    if (!rows.empty()) text += "| scene | status | within 2/255 | tracing | process |\n|---|---|---|---|---|\n" + rows;
    if (!rows.empty() && !others.empty()) text += '\n';
    if (!others.empty()) text += "Lack features: " + others + ".\n";
  }
  return text;
}

}  // namespace firstlight::app::compare
