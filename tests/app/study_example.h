#pragma once

#include "app/study/study.h"

#include <cmath>
#include <cstdint>

namespace firstlight::app {

/// A scheme whose difference falls as (1 - share) ^ steepness, with a thousand primary and three thousand shadow rays.
inline SchemeStudy made_up_scheme(const std::string& name, double seconds, double steepness) {
  SchemeStudy scheme;
  scheme.scheme = name;
  scheme.seconds = {seconds, 1.1 * seconds, 0.9 * seconds};
  scheme.preview = Reached{0.02 * seconds, 0.02};
  scheme.statistics.rays.of(render::RayKind::primary) = 1000;
  scheme.statistics.rays.of(render::RayKind::shadow) = 3000;
  scheme.statistics.peak_rays = 250;
  scheme.statistics.peak_bytes = 16'000;
  scheme.statistics.worst_case_rays = 1000;
  for (int step = 1; step <= 100; ++step) {
    Moment moment;
    const double share = step / 100.0;
    moment.seconds = share * seconds;
    moment.traced.of(render::RayKind::primary) = static_cast<std::uint64_t>(10 * step);
    moment.traced.of(render::RayKind::shadow) = static_cast<std::uint64_t>(30 * step);
    moment.rays_waiting = static_cast<std::uint64_t>(1000.0 * share * (1.0 - share));
    moment.queue_bytes = 64 * moment.rays_waiting;
    moment.difference = std::pow(1.0 - share, steepness);
    moment.flip = 0.8 * std::pow(1.0 - share, steepness / 2.0);
    moment.bound = 2.0 * moment.difference;
    scheme.moments.push_back(moment);
  }
  return scheme;
}

inline Study made_up_study() {
  Study study;
  study.scene = "room & garden.pov";
  study.command = "firstlight study 'room & garden.pov'";
  study.width = 40;
  study.height = 25;
  study.threads = 1;
  study.lights = 3;
  study.levels = 5;
  study.black_flip = 0.8;
  study.schemes = {made_up_scheme("recursive", 2.0, 1.0), made_up_scheme("contribution", 1.5, 9.0),
                   made_up_scheme("region(0,0,9,9), level<2", 3.0, 3.0)};
  return study;
}

}  // namespace firstlight::app
