#pragma once

#include "app/compare/record.h"

#include <limits>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// A scene that both programs rendered: POV-Ray traced for a second.
inline SceneRecord rendered_record(const std::string& name, double share, double our_trace, double our_wall = 1.0) {
  SceneRecord record;
  record.name = name;
  record.scene = "/scenes/" + name + ".pov";
  record.status = share >= 0.98 ? Status::agrees : Status::differs;
  PictureDifference difference;
  difference.width = 40;
  difference.height = 30;
  difference.share = share;
  difference.psnr = share == 1.0 ? std::numeric_limits<double>::infinity() : 31.5;
  difference.psnr_8x8 = difference.psnr;
  difference.worst = 17;
  difference.x = 3;
  difference.y = 4;
  difference.first = {1, 2, 3};
  difference.second = {4, 5, 20};
  record.difference = difference;
  record.povray = {{0.1, 1.0, 2.0, 1.5, 1000}};
  record.ours = {{0.1, our_trace, our_wall, 0.5, 2000}};
  return record;
}

inline SceneRecord lacking_record(const std::string& name, const std::vector<std::string>& features) {
  SceneRecord record;
  record.name = name;
  record.scene = "/scenes/" + name + ".pov";
  record.status = Status::lacks_features;
  for (const std::string& feature : features) record.missing.push_back({feature, "a.inc", 3, 7});
  return record;
}

}  // namespace firstlight::app::compare
