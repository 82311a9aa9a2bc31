#include "app/compare/record_json.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace firstlight::app::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 8> kStatusNames{"agrees",         "warns",       "differs",       "other_size",
                                                       "lacks_features", "ours_failed", "povray_failed", "both_failed"};

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const std::vector<ProgramRun>& runs) {
  Json json = Json::array();
  for (const ProgramRun& run : runs) json.push_back(compare::to_json(run));
  return json;
}

}  // namespace

std::string_view status_name(Status status) { return kStatusNames[static_cast<std::size_t>(status)]; }

Json to_json(const ProgramRun& run) {
  return {{"parse_s", run.parse},
          {"trace_s", run.trace},
          {"wall_s", run.wall},
          {"processor_s", run.processor},
          {"peak_bytes", run.peak_bytes}};
}

Json to_json(const PictureDifference& difference) {
  return {{"width", difference.width},
          {"height", difference.height},
          {"share", difference.share},
          {"mean", difference.mean},
          {"rms", difference.rms},
          {"psnr", finite(difference.psnr)},
          {"psnr_8x8", finite(difference.psnr_8x8)},
          {"flip", difference.flip},
          {"worst", difference.worst},
          {"x", difference.x},
          {"y", difference.y},
          {"first", difference.first},
          {"second", difference.second}};
}

Json to_json(const SceneRecord& record) {
  Json json;
  json["name"] = record.name;
  json["scene"] = record.scene.string();
  json["status"] = status_name(record.status);
  json["message"] = record.message;
  json["povray_message"] = record.povray_message;
  json["difference"] = record.difference ? to_json(*record.difference) : Json(nullptr);
  json["povray"] = to_json(record.povray);
  json["firstlight"] = to_json(record.ours);
  json["missing"] = Json::array();
  for (const MissingFeature& missing : record.missing) {
    json["missing"].push_back(
        {{"feature", missing.feature}, {"file", missing.file}, {"line", missing.line}, {"column", missing.column}});
  }
  json["povray_picture"] = record.povray_picture.string();
  json["our_picture"] = record.our_picture.string();
  return json;
}

std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace firstlight::app::compare
