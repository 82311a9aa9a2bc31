#include "app/stats.h"

#include "app/ending.h"
#include "render/image/link_target.h"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace firstlight::app {

std::string to_json(const Stats& stats) {
  using Json = nlohmann::ordered_json;
  const render::RayCounts& rays = stats.rays.rays;
  Json json;
  json["scene"] = stats.scene;
  json["scheme"] = stats.scheme;
  json["threads"] = stats.threads;
  json["width"] = stats.width;
  json["height"] = stats.height;
  json["time"] = {{"parse_s", stats.parse},
                  {"build_s", stats.build},
                  {"preview_s", stats.preview ? Json(*stats.preview) : Json()},
                  {"first_image_s", stats.first_image ? Json(*stats.first_image) : Json()},
                  {"trace_s", stats.trace},
                  {"total_s", stats.total}};
  json["rays"] = {{"primary", rays.of(render::RayKind::primary)},
                  {"reflection", rays.of(render::RayKind::reflection)},
                  {"transmission", rays.of(render::RayKind::transmission)},
                  {"shadow", rays.of(render::RayKind::shadow)}};
  json["untraced"] = {{"clear_feelers", rays.clear}, {"blocked_feelers", rays.blocked}};
  json["end"] = {{"reason", end_name(stats.end)},
                 {"remaining", stats.rays.remaining},
                 {"remaining_is_bound", stats.rays.remaining_is_bound}};
  json["queue"] = {{"memory", stats.queue_memory},
                   {"peak_rays", stats.rays.peak_rays},
                   {"peak_bytes", stats.rays.peak_bytes},
                   {"bytes_per_ray", stats.rays.bytes_per_ray},
                   {"worst_case_rays", stats.rays.worst_case_rays},
                   {"inverted_rays", stats.rays.inverted_rays}};
  json["rekeying"] = {{"count", stats.rays.rekeying.count},
                      {"rays", stats.rays.rekeying.rays},
                      {"longest_s", stats.rays.rekeying.longest_s}};
  // A path that is not UTF-8 must not cost the statistics.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string write_text_file(const std::string& name, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const std::string path = render::link_target(name).string();
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    // A pipe or device is written to, never replaced.
    std::ofstream stream(path, std::ios::binary);
    stream << text << std::flush;
    return stream ? "" : fmt::format("cannot write '{}'", name);
  }
  const std::string beside = fmt::format("{}.{}.part", path, static_cast<long>(::getpid()));
  {
    std::ofstream stream(beside, std::ios::binary);
    stream << text << std::flush;
    if (!stream) {
      fs::remove(beside, error);
      return fmt::format("cannot write '{}'", name);
    }
  }
  fs::rename(beside, path, error);
  if (!error) return {};
  const std::string why = error.message();
  fs::remove(beside, error);
  return fmt::format("cannot write '{}': {}", name, why);
}

}  // namespace firstlight::app
