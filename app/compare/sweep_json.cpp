#include "app/compare/sweep_json.h"

#include "app/compare/record_json.h"
#include "app/compare/record_text.h"
#include "app/compare/totals.h"

#include <string>

namespace firstlight::app::compare {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json json_of(const Totals& totals) {
  Json json;
  json["scenes"] = totals.scenes;
  for (std::size_t i = 0; i < kStatuses; ++i) {
    json["status"][std::string(status_name(static_cast<Status>(i)))] = totals.by_status[i];
  }
  json["timed"] = totals.timed;
  json["trace_ratio"] = or_null(totals.trace_ratio);
  json["whole_ratio"] = or_null(totals.whole_ratio);
  json["slower_trace"] = totals.slower_trace;
  json["slower_whole"] = totals.slower_whole;
  json["missing"] = Json::array();
  for (const FeatureCount& count : totals.missing) {
    json["missing"].push_back({{"feature", count.feature}, {"scenes", count.scenes}, {"alone", count.alone}});
  }
  return json;
}

}  // namespace

Json sweep_json(std::span<const SceneRecord> records) {
  Json json;
  json["totals"] = json_of(totals(records));
  json["scenes"] = Json::array();
  for (const SceneRecord& record : records) json["scenes"].push_back(Json::parse(scene_json(record, {})));
  return json;
}

}  // namespace firstlight::app::compare
