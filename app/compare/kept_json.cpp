#include "app/compare/kept_json.h"

#include "app/compare/record_json.h"
#include "app/compare/totals.h"

#include <limits>
#include <vector>

namespace firstlight::app::compare {
namespace {

using Json = nlohmann::ordered_json;

double number_of(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

PictureDifference difference_of(const Json& json) {
  PictureDifference difference;
  json.at("width").get_to(difference.width);
  json.at("height").get_to(difference.height);
  json.at("share").get_to(difference.share);
  json.at("mean").get_to(difference.mean);
  json.at("rms").get_to(difference.rms);
  difference.psnr = number_of(json.at("psnr"));
  difference.psnr_8x8 = number_of(json.at("psnr_8x8"));
  json.at("flip").get_to(difference.flip);
  json.at("worst").get_to(difference.worst);
  json.at("x").get_to(difference.x);
  json.at("y").get_to(difference.y);
  json.at("first").get_to(difference.first);
  json.at("second").get_to(difference.second);
  return difference;
}

std::vector<ProgramRun> runs_of(const Json& json) {
  std::vector<ProgramRun> runs;
  for (const Json& run : json) runs.push_back(run_of(run));
  return runs;
}

}  // namespace

ProgramRun run_of(const Json& json) {
  ProgramRun run;
  json.at("parse_s").get_to(run.parse);
  json.at("trace_s").get_to(run.trace);
  json.at("wall_s").get_to(run.wall);
  json.at("processor_s").get_to(run.processor);
  json.at("peak_bytes").get_to(run.peak_bytes);
  return run;
}

std::optional<SceneRecord> record_of(const Json& json) try {
  SceneRecord record;
  json.at("name").get_to(record.name);
  record.scene = json.at("scene").get<std::string>();
  const auto status = json.at("status").get<std::string>();
  std::size_t number = 0;
  while (number < kStatuses && status_name(static_cast<Status>(number)) != status) ++number;
  if (number == kStatuses) return std::nullopt;
  record.status = static_cast<Status>(number);
  json.at("message").get_to(record.message);
  json.at("povray_message").get_to(record.povray_message);
  if (!json.at("difference").is_null()) record.difference = difference_of(json.at("difference"));
  record.povray = runs_of(json.at("povray"));
  record.ours = runs_of(json.at("firstlight"));
  for (const Json& one : json.at("missing")) {
    record.missing.push_back({one.at("feature").get<std::string>(), one.at("file").get<std::string>(),
                              one.at("line").get<int>(), one.at("column").get<int>()});
  }
  record.povray_picture = json.at("povray_picture").get<std::string>();
  record.our_picture = json.at("our_picture").get<std::string>();
  return record;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

}  // namespace firstlight::app::compare
