#include "app/compare/record_text.h"

#include "app/compare/record_json.h"
#include "app/study/curve.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace firstlight::app::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr Measure kMeasures[] = {
    {"parse", "parse_s", "s", 1.0, [](const ProgramRun& run) { return run.parse; }},
    {"trace", "trace_s", "s", 1.0, [](const ProgramRun& run) { return run.trace; }},
    {"whole, wall", "wall_s", "s", 1.0, [](const ProgramRun& run) { return run.wall; }},
    {"whole, processor", "processor_s", "s", 1.0, [](const ProgramRun& run) { return run.processor; }},
    {"memory", "peak_bytes", "MB", 1e-6, [](const ProgramRun& run) { return static_cast<double>(run.peak_bytes); }},
};

std::vector<double> values(std::span<const ProgramRun> runs, const Measure& measure) {
  std::vector<double> out;
  for (const ProgramRun& run : runs) out.push_back(measure.of(run) * measure.scale);
  return out;
}

/// "1.234 s", of several runs "1.234 s (1.200 to 1.301)".
std::string numbers_text(std::span<const double> numbers, int digits, std::string_view unit) {
  if (numbers.empty()) return "-";
  const Spread spread = spread_of(numbers);
  std::string text = fmt::format("{:.{}f}{}{}", spread.median, digits, unit.empty() ? "" : " ", unit);
  if (numbers.size() > 1) text += fmt::format(" ({:.{}f} to {:.{}f})", spread.least, digits, spread.most, digits);
  return text;
}

std::string decibels(double psnr) { return std::isinf(psnr) ? "infinite" : fmt::format("{:.2f} dB", psnr); }

Json medians(std::span<const ProgramRun> runs) {
  Json json = Json::object();
  for (const Measure& measure : kMeasures) {
    std::vector<double> numbers;
    for (const ProgramRun& run : runs) numbers.push_back(measure.of(run));
    if (!numbers.empty()) json[std::string(measure.name)] = spread_of(numbers).median;
  }
  return json;
}

void add_maps(Json& json, const KeptMaps& kept) {
  json["difference_picture"] = kept.difference;
  json["flip_picture"] = kept.flip;
}

}  // namespace

Spread spread_of(std::span<const double> values) {
  const auto [least, most] = std::ranges::minmax(values);
  return {median(values), least, most};
}

std::span<const Measure> measures() { return kMeasures; }

std::vector<double> ratios(const SceneRecord& record, const Measure& measure) {
  std::vector<double> out;
  for (std::size_t i = 0; i < std::min(record.povray.size(), record.ours.size()); ++i) {
    const double ours = measure.of(record.ours[i]);
    if (ours <= 0.0) return {};
    out.push_back(measure.of(record.povray[i]) / ours);
  }
  return out;
}

std::string summary(const PictureDifference& difference) {
  return fmt::format("{:.2f} % of the pixels agree, PSNR {}, worst pixel ({}, {}): ({}) against ({}), {} of 255 apart",
                     100.0 * difference.share, decibels(difference.psnr), difference.x, difference.y,
                     fmt::join(difference.first, ", "), fmt::join(difference.second, ", "), difference.worst);
}

std::string to_text(const PictureDifference& difference, std::string_view first, std::string_view second) {
  std::string text;
  const auto line = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<20}{}\n", label, value);
  };
  line("within 2/255", fmt::format("{:.2f} % of the pixels", 100.0 * difference.share));
  line("worst pixel",
       difference.worst == 0
           ? "none, the pictures are equal"
           : fmt::format("({}, {}), {} of 255 apart: ({}) {}, ({}) {}", difference.x, difference.y, difference.worst,
                         fmt::join(difference.first, ", "), first, fmt::join(difference.second, ", "), second));
  line("mean, RMS error", fmt::format("{:.4f}, {:.4f} of 255", difference.mean, difference.rms));
  line("PSNR", decibels(difference.psnr));
  line("PSNR of 8x8 means", decibels(difference.psnr_8x8));
  line("FLIP", fmt::format("{:.4f}", difference.flip));
  return text;
}

std::string times_to_text(const SceneRecord& record) {
  if (record.povray.empty() || record.ours.empty()) return {};
  const bool several = record.ours.size() > 1;
  const int column = several ? 28 : 12;
  std::string text = fmt::format("  {:<20}{:<{}}{:<{}}POV-Ray's / Firstlight's\n", several ? "medians (range)" : "",
                                 "POV-Ray", column, "Firstlight", column);
  for (const Measure& measure : kMeasures) {
    const int digits = measure.unit == "s" ? 3 : 1;
    text += fmt::format("  {:<20}{:<{}}{:<{}}{}\n", measure.label,
                        numbers_text(values(record.povray, measure), digits, measure.unit), column,
                        numbers_text(values(record.ours, measure), digits, measure.unit), column,
                        numbers_text(ratios(record, measure), 2, ""));
  }
  return text;
}

std::string to_text(std::span<const MissingFeature> missing) {
  std::string text;
  for (const MissingFeature& feature : missing) {
    text += fmt::format("  {}:{}:{}: {}\n", feature.file, feature.line, feature.column, feature.feature);
  }
  return text;
}

std::string scene_json(const SceneRecord& record, const KeptMaps& kept) {
  Json json = to_json(record);
  json["medians"] = {{"povray", medians(record.povray)}, {"firstlight", medians(record.ours)}};
  json["ratios"] = Json::object();
  for (const Measure& measure : kMeasures) {
    const std::vector<double> found = ratios(record, measure);
    if (found.empty()) continue;
    const Spread spread = spread_of(found);
    json["ratios"][std::string(measure.name)] = {
        {"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
  }
  add_maps(json, kept);
  return text_of(json);
}

std::string pictures_json(std::string_view first, std::string_view second, std::string_view status,
                          const PictureDifference* difference, std::string_view message, const KeptMaps& kept) {
  Json json;
  json["first"] = first;
  json["second"] = second;
  json["status"] = status;
  json["message"] = message;
  json["difference"] = difference != nullptr ? to_json(*difference) : Json(nullptr);
  add_maps(json, kept);
  return text_of(json);
}

}  // namespace firstlight::app::compare
